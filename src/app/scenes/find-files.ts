import type { Diagnostic } from '../../core/diagnostics.ts';
import { defaultLimits } from '../../core/limits.ts';
import type { SourceFile } from '../../document/scene.ts';
import { nameKey } from '../../formats/belonging/paths.ts';
import { baseName } from '../../formats/file-entry.ts';
import type { FileEntry } from '../../formats/format.ts';
import { withHash } from './hash-files.ts';

/** Finds the files of scenes among those that the page has, by what is in them. */
export class FileFinder {
  private readonly known: readonly FileEntry[];
  private readonly given: Promise<readonly FileEntry[]>;

  /**
   * @param known files of open characters
   * @param given files that came for the scene, which are taken by their names as well
   */
  constructor(known: readonly FileEntry[], given: readonly FileEntry[]) {
    this.known = known;
    const readable = given.filter(
      ({ fault, size }) => fault === undefined && size <= defaultLimits.fileSize,
    );
    // A file that can't be read any more has no hash, and is reported when it is used.
    this.given = Promise.all(readable.map((file) => withHash(file).catch(() => file)));
  }

  /** Returns the file under the path that it has in the scene, or nothing. */
  async find(wanted: SourceFile, problems: Diagnostic[]): Promise<FileEntry | undefined> {
    const { path, sha256 } = wanted;
    const given = await this.given;
    const same = [...given, ...this.known].find((file) => sha256 !== '' && file.sha256 === sha256);
    if (same) return { ...same, path };
    const name = nameKey(baseName(path));
    const namesake = given.find((file) => nameKey(baseName(file.path)) === name);
    if (!namesake) return undefined;
    // Where the page computes no hash, nothing tells whether it is the same file.
    if (namesake.sha256 !== undefined && sha256 !== '') problems.push(changed(path));
    return { ...namesake, path };
  }
}

function changed(path: string): Diagnostic {
  return {
    severity: 'warning',
    code: 'file/pairing',
    file: baseName(path),
    expected: 'the file that the scene was made with',
    found: 'another one of its name',
    effect: 'it is used; the character may differ from the one that was saved',
  };
}
