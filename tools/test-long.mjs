/**
 * `npm run test:long` runs the checks of tools/long-checks.mjs on the app as it is built now. Names
 * and options choose among them: `npm run test:long -- soak --seed 3 --minutes 2`.
 */
import { spawnSync } from 'node:child_process';
import { packageCommand, root } from './commands.mjs';
import { install } from './install.mjs';
import { chosenChecks } from './long-checks.mjs';

try {
  const chosen = chosenChecks(process.argv.slice(2));
  install();
  run(packageCommand('vite', ['build', '--logLevel=warn']));
  for (const { check, environment } of chosen) {
    console.log(`${check.name}: ${check.what}`);
    run(commandOf(check), environment);
  }
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
}

/** @param {import('./long-checks.mjs').LongCheck} check */
function commandOf({ kind, tests }) {
  if (kind === 'unit') return packageCommand('vitest', ['run', tests, '--testTimeout=0']);
  // Checks run one at a time, so that a hang or a leak can be told from a check that waits for its
  // turn.
  const options = ['--workers=1', '--global-timeout=0', '--reporter=list'];
  return packageCommand('@playwright/test', ['test', tests, ...options], 'playwright');
}

/**
 * Runs a command and shows its output; throws if it fails.
 * @param {string[]} command
 * @param {Record<string, string>} [environment]
 */
function run([program = '', ...words], environment = {}) {
  const { status, error } = spawnSync(program, words, {
    cwd: root,
    env: { ...process.env, ...environment },
    stdio: 'inherit',
  });
  if (status !== 0) throw error ?? new Error(`failed: ${words.slice(1).join(' ')}`);
}
