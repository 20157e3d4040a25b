import { afterEach, beforeEach, vi } from 'vitest';
import { commands } from '../../src/cli/commands.ts';
import type { FileContents } from '../support/files.ts';
import { folderWith } from './run-sinew.ts';

/** Records the lines that commands print in each test of a file; the lists are emptied before it. */
export function recordLines(): { readonly errors: string[]; readonly out: string[] } {
  const [errors, out]: [string[], string[]] = [[], []];
  beforeEach(() => {
    [errors.length, out.length] = [0, 0];
    vi.spyOn(console, 'error').mockImplementation((line: string) => errors.push(line));
    vi.spyOn(console, 'log').mockImplementation((line: string) => out.push(line));
  });
  afterEach(() => {
    vi.restoreAllMocks();
    vi.unstubAllEnvs();
  });
  return { errors, out };
}

/** Runs a command in this process, in a folder with these files. */
export function runCommand(name: string, contents: FileContents, ...words: string[]) {
  const folder = folderWith(contents);
  vi.stubEnv('INIT_CWD', folder);
  return { folder, code: commands.find((command) => command.name === name)!.run(words) };
}
