import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { LineReader } from '../text/line-reader.ts';

/** Elements of OBJ other than faces. */
const elements = new Set(['l', 'p', 'curv', 'curv2', 'surf', 'vp', 'cstype', 'deg']);

/** More kinds than any useful file has; after this many, every line is counted. */
const mostKinds = 1000;

/** Reports once for each kind of line that it is ignored. */
export class IgnoredKeywords {
  private readonly noted = new Set<string>();
  private readonly reader: LineReader;
  private readonly log: DiagnosticLog;

  constructor(reader: LineReader, log: DiagnosticLog) {
    this.reader = reader;
    this.log = log;
  }

  note(keyword: string): void {
    if (this.noted.has(keyword)) return;
    if (this.noted.size < mostKinds) this.noted.add(keyword);
    const isLibrary = keyword === 'mtllib';
    this.log.warn({
      ...this.reader.place,
      ...(isLibrary ? this.missingLibrary() : leftOut(keyword)),
    });
  }

  /** The materials are in another file, which is not there. */
  private missingLibrary() {
    return {
      code: 'obj/missing',
      expected: 'the material library among the files',
      found: `mtllib ${this.reader.rest()}`,
      effect: 'the surface is plain',
    } as const;
  }
}

function leftOut(keyword: string) {
  return {
    code: elements.has(keyword) ? 'obj/ignored' : 'obj/unknown',
    expected: 'vertices, texture coordinates, normals and faces',
    found: keyword,
    effect: 'such lines are left out',
  } as const;
}
