import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { cacheFolder } from '../../tools/commands.mjs';
import { courseFiles, courseSizes } from '../data/course-files.ts';
import { cylinder } from '../data/cylinder.ts';
import { buildPrograms } from '../harness/build-pages.ts';
import type { GroupResult, Value } from '../harness/group.ts';
import { spreadOf } from '../harness/statistics.ts';
import { readerKinds, type ReaderKind } from '../readers/sinew.ts';

const runs = 3;

/**
 * The sizes whose peaks are measured. A PMD has nearly as many vertices as it can hold: beside a
 * smaller file, the engine's own reserve of some megabytes would be most of what is measured.
 */
const sizes = { ...courseSizes, pmd: 65_000 };

/** The peak of memory while a file is read, in a process for each reader and file. */
export async function memory(): Promise<GroupResult> {
  const programs = await buildPrograms('memory', {
    sinew: 'memory/sinew.ts',
    peer: 'peers/memory.mjs',
  });
  const folder = path.join(cacheFolder, 'bench/files');
  mkdirSync(folder, { recursive: true });
  const small = cylinder({ vertexCount: 100 });
  const values: Record<string, Value> = {};
  const counts: Record<string, number> = {};
  for (const kind of readerKinds) {
    const [file, smallFile] = [`body.${kind}`, `small.${kind}`].map((name) =>
      path.join(folder, name),
    ) as [string, string];
    const bytes = courseFiles[kind](cylinder({ vertexCount: sizes[kind] }));
    writeFileSync(file, bytes);
    writeFileSync(smallFile, courseFiles[kind](small));
    const ratioOf = (program: string): number[] =>
      Array.from({ length: runs }, () => rise(program, kind, file, smallFile) / bytes.length);
    const { lower, median, upper } = spreadOf(ratioOf(programs['sinew']!));
    values[`memory-${kind}`] = { value: median, lower, upper };
    counts[`peak of the peer, .${kind}, × size of the file`] = spreadOf(
      ratioOf(programs['peer']!),
    ).median;
  }
  return { values, samples: {}, counts };
}

function rise(program: string, kind: ReaderKind, file: string, smallFile: string): number {
  const words = [program, kind, file, smallFile];
  return Number(execFileSync(process.execPath, words, { encoding: 'utf8' }));
}
