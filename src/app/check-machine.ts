import { Failure } from '../core/failure.ts';
import type { ReadProgress } from '../formats/read-characters.ts';
import { checkView, type ViewReport } from '../view/machine-check/check-view.ts';
import { fetchBundled, fetchCatalogue } from './catalogue.ts';
import { readFiles } from './read-files.ts';

/** The saved form of the check of a machine; docs/machine-check.md describes it. */
export interface MachineReport extends ViewReport {
  /** One line for the user. */
  readonly summary: string;
  /** When the check ended, in ISO 8601. */
  readonly time: string;
  readonly character: string;
}

/**
 * Measures this machine with the first bundled character, so that reports can be compared.
 *
 * @throws Failure if the character or a part of Sinew can't be loaded, or without WebGL2
 */
export async function checkMachine(
  signal: AbortSignal,
  onProgress: ReadProgress,
): Promise<MachineReport> {
  const {
    characters: [entry],
  } = await fetchCatalogue();
  if (!entry) throw new Failure('There is no bundled character to check this machine with');
  const files = await fetchBundled(entry, signal);
  const parts = files.filter(({ path }) => !path.endsWith('.json'));
  const { characters } = await readFiles(parts, signal, () => undefined);
  signal.throwIfAborted();
  const [read] = characters;
  if (!read) throw new Failure('The character of the check could not be read');
  const report = await checkView(read.character, signal, onProgress);
  return {
    summary: summaryOf(report),
    time: new Date().toISOString(),
    character: entry.id,
    ...report,
  };
}

function summaryOf({ programs, parity, frames }: ViewReport): string {
  const failed = programs.filter(({ problem }) => problem !== null).length;
  const different = parity.filter(({ identical }) => !identical).length;
  return [
    failed === 0
      ? `${programs.length} programs link`
      : `${failed} of ${programs.length} programs fail`,
    different === 0 ? 'GPU = CPU' : `${different} of ${parity.length} methods differ from the CPU`,
    `posed frame ${frames.posed.median.toFixed(1)} ms`,
    `camera ${frames.camera.median.toFixed(1)} ms`,
  ].join(', ');
}
