import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { LineReader } from '../text/line-reader.ts';

/** Elements of OBJ other than faces. */
const elements = new Set(['l', 'p', 'curv', 'curv2', 'surf', 'mtllib', 'vp', 'cstype', 'deg']);

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
    const library = keyword === 'mtllib';
    this.log.warn({
      code: library || elements.has(keyword) ? 'obj/ignored' : 'obj/unknown',
      ...this.reader.place,
      expected: 'vertices, texture coordinates, normals and faces',
      found: library ? `mtllib ${this.reader.rest()}` : keyword,
      effect: library ? 'materials are not read; the surface is plain' : 'such lines are left out',
    });
  }
}
