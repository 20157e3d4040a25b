import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { gunzipSync } from 'node:zlib';
import { cacheFolder, packageCommand, root } from '../../tools/commands.mjs';
import { type BenchOptions, expectRight, type GroupResult, timesSlower } from '../harness/group.ts';
import { type Contender, measure } from '../harness/measure.ts';

/** The command line against a program that does nothing. */
export async function commandLine({ rounds }: BenchOptions): Promise<GroupResult> {
  const bundle = path.join(root, 'build/sinew.mjs');
  const isBundled = existsSync(bundle);
  const program = isBundled
    ? [process.execPath, bundle]
    : packageCommand('tsx', [path.join(root, 'src/cli/main.ts')]);
  const info = [...program, 'info', ...unpackedHuman()];
  const nothing = [process.execPath, '-e', '0'];
  expectRight(/14307 vertices/.test(run(info)), 'info names the number of vertices');
  const contenders: readonly Contender[] = [
    { id: 'sinew info', sample: () => timed(info) },
    { id: 'node -e 0', sample: () => timed(nothing) },
  ];
  const samples = await measure(contenders, rounds);
  return {
    samples,
    values: { info: timesSlower(samples, 'sinew info', 'node -e 0') },
    counts: { 'the command line': isBundled ? 'build/sinew.mjs' : 'by tsx, from its sources' },
  };
}

/** The files of the bundled human as a course gives them: unpacked. */
function unpackedHuman(): string[] {
  const from = path.join(root, 'public/data/human');
  const to = path.join(cacheFolder, 'bench/human');
  mkdirSync(to, { recursive: true });
  return readdirSync(from)
    .filter((name) => name.endsWith('.gz'))
    .map((name) => {
      const file = path.join(to, name.slice(0, -'.gz'.length));
      writeFileSync(file, gunzipSync(readFileSync(path.join(from, name))));
      return file;
    });
}

function timed(command: readonly string[]): { wall: number } {
  const begin = performance.now();
  run(command);
  return { wall: performance.now() - begin };
}

function run([program = '', ...words]: readonly string[]): string {
  const { status, stdout, stderr } = spawnSync(program, words, { encoding: 'utf8' });
  expectRight(status === 0, `${words.join(' ')}: ${stderr}`);
  return stdout;
}
