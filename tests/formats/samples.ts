import { leg, legMorph, legRig, legSkel, legSkin } from '../support/cse169-files.ts';
import { courseSkel } from '../support/course-skeleton.ts';
import type { FileContents } from '../support/files.ts';
import { golden, oddities } from '../support/golden.ts';
import { pmdFile, square as squareContent, squarePmd } from '../support/pmd-files.ts';

/** The samples with which a format is tested; every format of the registry needs an entry here. */
export interface FormatSamples {
  /** Small complete characters, for tests of truncation and mutation. */
  readonly characters: Readonly<Record<string, FileContents>>;
  /** Words that its readers know, for random texts. */
  readonly tokens: readonly string[];
  /** Numbers, and text that looks like numbers, at or beyond the limits of its readers. */
  readonly oddNumbers: readonly string[];
}

const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl\nf 1 3 4\n';

const oddNumbers = [
  ...['-1', '0', '1', '2', '7', '-2', '4095', '65536', '4294967297', '99999999999999999999'],
  ...['1e6', '-1e6', '1.000001e6', '1e18', '-1e18', '1.1e18', '1e38', '1e39', '1e400'],
  ...['1e-7', '1e-6', '1e-40', '-1e-45', '-0', '0.0', '+1', '1.', '.5', '1e', '1e+', '.', '--1'],
  ...['nan', 'NaN', 'inf', '-Infinity', '0x10', '1,5', '1_0', '1/1', '1//1', '\u0661', '1\0'],
  '9'.repeat(65),
];

const mit: FormatSamples = {
  characters: {
    'with all oddities': golden(...oddities),
    plain: {
      'a.skel': '0 0 0 -1\n0 1 0 0\n0 1 0 1\n',
      'a.obj': square,
      'a.attach': '1 0\n0.25 0.75\n0 1\n0 0\n',
    },
    'a mesh alone': { 'a.obj': square },
    'a mesh with materials': {
      'a.obj': `mtllib a.mtl\n${square}`,
      'a.mtl': 'newmtl a\nKd 0.5 0.25 1\nKs 1 1 1\nNs 20\nd 0.5\nmap_Kd -s 1 1 a b.png\n',
    },
    "the course's skeleton alone": { 'a.skel': courseSkel },
  },
  tokens: [
    ...['v', 'vt', 'vn', 'f', 'o', 'g', 's', 'usemtl', 'mtllib', 'l', '#', '\\', 'balljoint'],
    ...['0', '1', '2', '3', '-1', '-2', '0.5', '1e-3', '1e39', '1e400', 'nan', '1e', '.', '-'],
    ...['newmtl', 'Kd', 'Ks', 'Ka', 'Ns', 'd', 'Tr', 'map_Kd', '-s', 'a.png'],
    ...['1/1', '1//1', '1/2/3', '1/', '/', '//', '1/2/3/4', '__proto__', '<img>', '骨', '\u202e'],
  ],
  oddNumbers,
};

const cse169: FormatSamples = {
  characters: {
    'a skeleton, skin, morph and clip': leg,
    'a rig that names its files': {
      'leg.rig': legRig,
      'leg.skel': legSkel,
      'leg.skin': legSkin,
      'bent.morph': legMorph,
    },
    'a skeleton alone, with odd line ends': {
      'a.skel': 'balljoint  {\r\r\n  pose 0 9 0\r}\rballjoint a{ boxmin 1 1 1 }\r\nballjoint a { }',
    },
    'a skin alone, without skinweights': {
      'a.skin': 'positions 3 { 0 0 0 1 0 0 0 1 0 } triangles 1 { 0 1 2 } material {}',
    },
  },
  tokens: [
    ...['balljoint', 'offset', 'boxmin', 'boxmax', 'rotxlimit', 'pose', '{', '}', '{', '}', '//'],
    ...['positions', 'normals', 'texcoords', 'skinweights', 'material', 'texture', 'triangles'],
    ...['bindings', 'matrix', 'animation', 'range', 'numchannels', 'channel', 'extrapolate'],
    ...['keys', 'flat', 'smooth', 'cycle_offset', 'bounce', 'rig', 'skeleton', 'skin', 'morphs'],
    ...['0', '1', '2', '3', '-1', '0.5', '1e39', 'nan', '1.#QNAN', '/*', '*/', '#', '__proto__'],
  ],
  oddNumbers,
};

const mmd: FormatSamples = {
  characters: {
    'every section': { 'a.pmd': squarePmd },
    'bones alone': {
      'a.pmd': pmdFile({
        ...squareContent,
        ...{
          vertices: [],
          indices: [],
          materials: [],
          morphs: [],
          shownMorphs: [],
          last: 'display',
        },
      }).bytes,
    },
    'a mesh alone': {
      'a.pmd': pmdFile({
        ...squareContent,
        ...{ bones: [], ik: [], listed: [], bodies: [], springs: [], last: 'toons' },
      }).bytes,
    },
  },
  tokens: [
    'Pmd',
    'PMX ',
    'Vocaloid Motion Data 0002',
    'PK',
    '\0',
    '\xff',
    '\x80\x3f',
    'a.bmp',
    '*',
  ],
  oddNumbers,
};

export const formatSamples: Readonly<Record<string, FormatSamples | undefined>> = {
  mit,
  cse169,
  mmd,
};
