import { readFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { findBrowser } from '../../tools/browser.mjs';
import { root } from '../../tools/commands.mjs';

/** Where the numbers come from. */
export interface Machine {
  readonly processor: string;
  readonly cores: number;
  readonly memoryGiB: number;
  readonly system: string;
  readonly versions: Readonly<Record<string, string>>;
}

export function describeMachine(): Machine {
  const cores = os.cpus();
  return {
    processor: cores[0]?.model.trim() ?? 'unknown',
    cores: cores.length,
    memoryGiB: Math.round(os.totalmem() / 2 ** 30),
    system: `${os.type()} ${os.arch()}`,
    versions: {
      node: process.versions.node,
      v8: process.versions.v8,
      browser: findBrowser().name,
      ...peerVersions(),
    },
  };
}

/** The mean number of processes that wanted to run in the last minute. */
export function loadAverage(): number {
  return os.loadavg()[0]!;
}

function peerVersions(): Record<string, string> {
  const { dependencies } = JSON.parse(
    readFileSync(path.join(root, 'bench/package.json'), 'utf8'),
  ) as { dependencies: Record<string, string> };
  return dependencies;
}
