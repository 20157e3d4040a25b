import { type DiagnosticLog, printable } from '../../core/diagnostics.ts';
import { textureExtensions } from '../extensions.ts';
import { baseName, extensionOf } from '../file-entry.ts';

const mostNames = 4;

/** The files of an archive that can't be unpacked: counted, and reported once for each reason. */
export class LeftOut {
  private readonly namesOf = new Map<string, string[]>();

  add(name: string, reason: string): void {
    const names = this.namesOf.get(reason) ?? [];
    names.push(baseName(name));
    this.namesOf.set(reason, names);
  }

  /** A missing image affects no numbers, so it is a warning; any other file is an error. */
  report(log: DiagnosticLog): void {
    for (const [reason, names] of this.namesOf) {
      const areImages = names.every((name) => textureExtensions.includes(extensionOf(name)));
      const shown = names.slice(0, mostNames).map((name) => `"${printable(name)}"`);
      const more = names.length > mostNames ? ` and ${names.length - mostNames} more` : '';
      const found = `${names.length} ${reason}: ${names[0]!}`;
      const effect = `left out: ${shown.join(', ')}${more}; the rest is read`;
      const details = { code: 'file/archive', expected: 'files that can be unpacked' } as const;
      if (areImages) log.warn({ ...details, found, effect });
      else log.errorOfPart({ ...details, found, effect });
    }
  }
}
