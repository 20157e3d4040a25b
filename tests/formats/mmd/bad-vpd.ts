import { bytesOf } from '../../support/files.ts';
import { center } from '../../support/pmd-files.ts';

/** "頭", "ﾈｸﾀｲ" in half width, and "aああああああああああ", whose 21 bytes a PMD cuts after 20. */
export const head = [0x93, 0xaa];
export const tie = [0xc8, 0xb8, 0xc0, 0xb2];
export const long = [0x61, ...Array.from({ length: 10 }, () => [0x82, 0xa0]).flat()];
/** "あ" */
export const vowel = [0x82, 0xa0];

export type Part = string | readonly number[];

/** The bytes of texts in ASCII and of names in Shift-JIS. */
export function bytes(...parts: readonly Part[]): Uint8Array {
  return Uint8Array.from(
    parts.flatMap((part) => (typeof part === 'string' ? [...bytesOf(part)] : part)),
  );
}

export const start = 'Vocaloid Pose Data file\r\n\r\nmodel.osm;\t\t// parent\r\n';
const values = '  1,2,3;\t// trans\r\n  0,0,0,1;\t// Quaternion\r\n}\r\n\r\n';

/** A bone's block at rest, with the name that stands in it. */
export const bone = (...name: readonly Part[]): Part[] => ['Bone0{', ...name, '\r\n', values];

/** A file, the messages about it, and where it puts センター along x; null if it is not used. */
type Row = readonly [
  title: string,
  file: Uint8Array,
  messages: readonly string[],
  x: number | null,
];

const whole = bytes(`${start}1;\r\n\r\n`, ...bone(center));
const one = (count: string, ...parts: readonly Part[]): Uint8Array =>
  bytes(`${start}${count}\r\n\r\n`, ...parts);
const block = (...rows: readonly string[]): Uint8Array =>
  one('1;', 'Bone0{', center, `\r\n${rows.join('\r\n')}\r\n`);
const rotation = '0,0,0,1;';

export const badPoses: readonly Row[] = [
  ['a good file', whole, [], 1],
  ['LF in place of CRLF', Uint8Array.from(whole.filter((byte) => byte !== 13)), [], 1],
  [
    'comments and blank lines between all lines',
    one(
      '1; // bones',
      '// a block\r\n\r\n',
      'Bone0{',
      center,
      '\r\n\r\n// x\r\n1,2,3;//t\r\n\r\n0,0,0,1;\r\n // end\r\n}\r\n',
    ),
    [],
    1,
  ],
  [
    'a name in half-width kana',
    one('2;', ...bone(center), ...bone(tie)),
    [
      'warning: a.vpd:11: expected offsets of bones that can be moved, found "ﾈｸﾀｲ" [vpd/ignored]; left out',
    ],
    1,
  ],
  [
    'a name that the PMD cut after 20 bytes',
    one('2;', ...bone(center), 'Bone1{', long, '\r\n0,0,0;\r\n0,0,0,1;\r\n}'),
    [],
    1,
  ],
  [
    'an empty file',
    bytes(),
    ['error: a.vpd: expected .vpd text, found "an empty file" [file/empty]; the file is not used'],
    null,
  ],
  [
    'UTF-16',
    bytes([0xff, 0xfe], 'V'),
    [
      'error: a.vpd: expected UTF-8 text, found "a UTF-16 byte order mark" [file/encoding]; the file is not used',
    ],
    null,
  ],
  [
    'a motion',
    bytes('Vocaloid Motion Data 0002\r\n'),
    [
      'error: a.vpd:1: expected "Vocaloid Pose Data file" (this is a motion file), found "Vocaloid Motion Data 0002" [vpd/magic]; the pose is not used',
    ],
    null,
  ],
  [
    'another text',
    bytes('\r\nhello\r\n'),
    [
      'error: a.vpd:2: expected "Vocaloid Pose Data file", found "hello" [vpd/magic]; the pose is not used',
    ],
    null,
  ],
  [
    'a UTF-8 byte order mark',
    bytes([0xef, 0xbb, 0xbf], `${start}1;\r\nBone0{`, [...bytesOf('センター')], `\r\n${values}`),
    [
      'warning: a.vpd:1: expected Shift-JIS text, found "a UTF-8 byte order mark" [vpd/encoding]; read as UTF-8',
    ],
    1,
  ],
  [
    'UTF-8 without a mark',
    bytes(`${start}1;\r\nBone0{`, [...bytesOf('センター')], `\r\n${values}`),
    ['warning: a.vpd:1: expected Shift-JIS text, found "UTF-8" [vpd/encoding]; read as UTF-8'],
    1,
  ],
  [
    'bytes of no encoding',
    one('2;', ...bone(center), 'Bone1{', [0xff], '\r\n0,0,0;\r\n0,0,0,1;\r\n}'),
    [
      'warning: a.vpd:11: expected Shift-JIS text, found "bytes that are no characters" [vpd/encoding]; names that have them may not be found',
      'warning: a.vpd:11: expected names of bones of the character, found "\uFFFD" [vpd/unknown-joint]; left out',
    ],
    1,
  ],
  [
    'no more than the signature',
    bytes('Vocaloid Pose Data file'),
    [
      'warning: a.vpd:1: expected the name of the model and ";", found "Vocaloid Pose Data file" [vpd/missing]; it has none',
      'warning: a.vpd:1: expected the count of bones and ";", found "Vocaloid Pose Data file" [vpd/missing]; they are counted',
      'warning: a.vpd: expected bones, found "none" [vpd/empty]; the pose changes nothing',
    ],
    0,
  ],
  [
    'no name of a model',
    bytes('Vocaloid Pose Data file\r\n1;\r\n', ...bone(center)),
    [
      'warning: a.vpd:2: expected the name of the model and ";", found "1;" [vpd/missing]; it has none',
    ],
    1,
  ],
  [
    'no semicolon after the name',
    bytes('Vocaloid Pose Data file\r\nm.osm\r\n1;\r\n', ...bone(center)),
    ['warning: a.vpd:2: expected ";", found "none" [vpd/token]; read as if it were there'],
    1,
  ],
  [
    'a count that is no number',
    one('some;', ...bone(center)),
    [
      'warning: a.vpd:4: expected the count of bones, a whole number, found "some" [vpd/integer]; they are counted',
    ],
    1,
  ],
  [
    'too large a count',
    one('55;', ...bone(center)),
    ['warning: a.vpd:4: expected 55 bones, found "1" [vpd/count]; those that are there are used'],
    1,
  ],
  [
    'too small a count',
    one('0;', ...bone(center)),
    ['warning: a.vpd:4: expected 0 bones, found "1" [vpd/count]; those that are there are used'],
    1,
  ],
  [
    'the end within a block',
    block('1,2,3;'),
    [
      'error: a.vpd:6: expected x, y, z, w of "センター", found "the end of its lines" [vpd/end]; this one is left out',
    ],
    0,
  ],
  [
    'the end before the brace',
    block('1,2,3;', rotation),
    [
      'warning: a.vpd:6: expected "}" after the values of "センター", found "none" [vpd/end]; read as if it were so',
    ],
    1,
  ],
  [
    'a block without its brace before another one',
    one(
      '2;',
      'Bone0{',
      center,
      '\r\n1,2,3;\r\n0,0,0,1;\r\n',
      'Bone1{',
      head,
      '\r\n0,0,0;\r\n0,0,0,1;\r\n}',
    ),
    [
      'warning: a.vpd:6: expected "}" after the values of "センター", found "none" [vpd/end]; read as if it were so',
    ],
    1,
  ],
  [
    'no semicolon after values',
    block('1,2,3', rotation, '}'),
    [
      'warning: a.vpd:7: expected ";" after x, y, z of "センター", found "none" [vpd/token]; read as if it were so',
    ],
    1,
  ],
  [
    'two values of three',
    block('1,2;', rotation, '}'),
    [
      'error: a.vpd:7: expected 3 numbers, x, y, z of "センター", found "2" [vpd/field-count]; this one is left out',
    ],
    0,
  ],
  [
    'NaN',
    block('nan,2,3;', rotation, '}'),
    [
      'error: a.vpd:7: expected a number in x, y, z of "センター", found "nan" [vpd/number]; this one is left out',
    ],
    0,
  ],
  [
    'a number beyond what can be computed with',
    block('1e40,2,3;', rotation, '}'),
    [
      'error: a.vpd:7: expected numbers within ±1e18 for x, y, z of "センター", found "1e40" [vpd/range]; this one is left out',
    ],
    0,
  ],
  [
    'no rotation',
    block('1,2,3;', '}'),
    [
      'error: a.vpd:6: expected x, y, z, w of "センター", found ""}"" [vpd/field-count]; this one is left out',
    ],
    0,
  ],
  [
    'a third row',
    block('1,2,3;', rotation, '4;', '}'),
    [
      'warning: a.vpd:9: expected "}" after x, y, z, w of "センター", found "4;" [vpd/trailing]; read as if it were so',
    ],
    1,
  ],
  [
    'a quaternion of another length',
    block('1,2,3;', '0,0,0,2;', '}'),
    [
      'warning: a.vpd:6: expected quaternions of length 1, found "2 for "センター"" [vpd/range]; made so',
    ],
    1,
  ],
  [
    'a quaternion without a length',
    block('1,2,3;', '0,0,0,0;', '}'),
    [
      'warning: a.vpd:6: expected quaternions with a length, found "0 for "センター"" [vpd/singular]; the bones stay as they are',
    ],
    1,
  ],
  [
    'bones of another model',
    one('3;', ...bone('tail'), ...bone(center), ...bone('wing')),
    [
      'warning: a.vpd:6: expected names of bones of the character, found "tail and 1 more" [vpd/unknown-joint]; left out',
    ],
    1,
  ],
  [
    'a bone twice',
    one('2;', 'Bone0{', center, '\r\n9,9,9;\r\n0,0,0,1;\r\n}\r\n', ...bone(center)),
    [
      'warning: a.vpd:10: expected each name once, found "センター" [vpd/duplicate]; the last one is used',
    ],
    1,
  ],
  [
    'a bone without a name',
    one('2;', ...bone(center), ...bone('')),
    ['error: a.vpd:11: expected the name of a bone, found "none" [vpd/name]; this one is left out'],
    1,
  ],
  [
    'text between blocks',
    one('1;', 'hello\r\n', ...bone(center)),
    [
      'error: a.vpd:6: expected a block such as "Bone0{NAME", found "hello" [vpd/token]; this line is left out',
    ],
    1,
  ],
  [
    'an unknown morph',
    one('1;', ...bone(center), 'Morph0{smile\r\n1;\r\n}'),
    [
      'warning: a.vpd:11: expected names of morphs of the character, found "smile" [vpd/unknown]; left out',
    ],
    1,
  ],
];
