/**
 * `npm test` runs every check of the project, on any machine with Node. The static checks run two
 * at a time, then the unit tests, then the browser tests against the built app. A check that fails
 * does not stop the others. The last line is `N passed, N failed`: the number of tests of both
 * kinds, where a failed check counts as one. tools/browser.mjs finds a browser, or gets one.
 *
 * `npm test -- --only=types,unit` runs only these groups.
 */
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, rmSync } from 'node:fs';
import path from 'node:path';
import { cacheFolder, npmCommand, packageCommand, readJson, root } from './commands.mjs';
import { install } from './install.mjs';

/**
 * @typedef {{ passed: number, failed: number, skipped: number }} Counts
 * @typedef {{ status: number, output: string, seconds: number }} Outcome
 * @typedef {{ name: string, state: 'ok' | 'failed' | 'skipped', seconds: number, note: string, counts: Counts }} Result
 * @typedef {{ group: string, name: string, command: () => string[], environment?: Record<string, string> }} Check
 */

const noTests = { passed: 0, failed: 0, skipped: 0 };
const oneFailure = { passed: 0, failed: 1, skipped: 0 };
/** This limit guards against hanging. */
const longestMinutes = 15;

/** @type {Check[]} The longest checks come first, so that the two lanes end together. */
const checks = [
  { group: 'lint', name: 'lint', command: () => packageCommand('oxlint') },
  {
    group: 'types',
    name: 'types',
    command: () => packageCommand('typescript-native', ['--build'], 'tsc'),
  },
  {
    group: 'format',
    name: 'format',
    command: () => packageCommand('oxfmt', ['--check']),
  },
  {
    group: 'unused',
    name: 'unused',
    command: () => packageCommand('knip', ['--no-progress']),
    // knip loads playwright.config.ts, which would search for a browser while the check below gets
    // one.
    environment: { TEST_BROWSER: 'playwright' },
  },
  {
    group: 'imports',
    name: 'imports',
    command: () =>
      packageCommand(
        'dependency-cruiser',
        ['src', 'tools', 'tests', 'e2e', 'bench'].filter((folder) =>
          existsSync(path.join(root, folder)),
        ),
        'depcruise',
      ),
  },
  {
    group: 'shaders',
    name: 'shaders',
    command: () => packageCommand('tsx', ['tools/check-shaders.ts']),
  },
  {
    group: 'e2e',
    name: 'browser',
    command: () => [process.execPath, path.join(root, 'tools/browser.mjs')],
  },
  { group: 'build', name: 'build', command: () => npmCommand(['run', '--silent', 'build']) },
];
const groups = [...new Set(checks.map(({ group }) => group)), 'unit'];

/** @type {Result[]} */
const results = [];
/** @type {Set<import('node:child_process').ChildProcess>} */
const running = new Set();
const started = performance.now();

for (const signal of /** @type {const} */ (['SIGINT', 'SIGTERM'])) {
  process.once(signal, () => {
    for (const child of running) child.kill(signal);
    process.exit(1);
  });
}

try {
  await main(chosenGroups(process.argv.slice(2)));
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  results.push({ ...result('npm test', 0), state: 'failed', counts: oneFailure });
}
report();

/**
 * Returns the groups to run; all groups if none is named.
 * @param {string[]} words
 */
function chosenGroups(words) {
  if (words.length === 0) return groups;
  const only = words.map((word) => /^--only=(.+)$/.exec(word)?.[1]?.split(',') ?? [word]).flat();
  const unknown = only.find((group) => !groups.includes(group));
  if (unknown !== undefined) {
    throw new Error(`"${unknown}" is not a check; use --only= with ${groups.join(',')}`);
  }
  // The browser tests must never run on a build of older sources.
  return only.includes('e2e') ? [...only, 'build'] : only;
}

/** @param {string[]} chosen */
async function main(chosen) {
  install();
  mkdirSync(cacheFolder, { recursive: true });

  const waiting = checks.filter(({ group }) => chosen.includes(group));
  const lane = async () => {
    for (let next = waiting.shift(); next !== undefined; next = waiting.shift()) {
      await runCheck(next);
    }
  };
  await Promise.all([lane(), lane()]);

  if (chosen.includes('unit')) await runUnitTests();
  if (chosen.includes('e2e')) await runBrowserTests();
}

/** @param {Check} check */
async function runCheck({ name, command, environment }) {
  const options = { quiet: true, ...(environment && { environment }) };
  const { status, output, seconds } = await run(command(), options);
  const skipped = /^skipped: (.*)/m.exec(output)?.[1];
  /** @type {Result} */
  const done = { ...result(name, seconds), state: status === 0 ? 'ok' : 'failed' };
  if (status !== 0) done.counts = oneFailure;
  else if (skipped !== undefined) Object.assign(done, { state: 'skipped', note: skipped });
  else if (name === 'browser') {
    process.env['TEST_BROWSER'] = output.trim().split('\n').at(-1);
    done.note = /^browser: (.*)\n(?!browser:)/m.exec(output)?.[1] ?? '';
  }
  results.push(done);
  console.log(line(done));
  if (status !== 0) console.log(indent(output));
}

async function runUnitTests() {
  const file = reportFile('unit');
  const reporters = ['--reporter=default', '--reporter=json', `--outputFile.json=${file}`];
  const { status, seconds } = await run(packageCommand('vitest', ['run', ...reporters]));
  const counts = { ...noTests };
  if (existsSync(file)) {
    const written = readJson(file);
    counts.passed = written.numPassedTests;
    counts.skipped = written.numPendingTests + written.numTodoTests;
    // A file that fails to load reports no tests; it counts as one failure.
    counts.failed =
      written.numFailedTests +
      written.testResults.filter(
        (/** @type {{ status: string, assertionResults: { status: string }[] }} */ each) =>
          each.status === 'failed' &&
          each.assertionResults.every(({ status }) => status !== 'failed'),
      ).length;
  }
  finishTests('unit', status, seconds, counts);
}

async function runBrowserTests() {
  const missing = results.find(
    ({ name, state }) => (name === 'build' || name === 'browser') && state === 'failed',
  );
  if (missing !== undefined) {
    const note = `not run: ${missing.name} failed`;
    results.push({ ...result('e2e', 0), state: 'skipped', note });
    console.log(line(results.at(-1)));
    return;
  }
  const file = reportFile('e2e');
  process.env['PLAYWRIGHT_JSON_OUTPUT_FILE'] = file;
  const { status, seconds } = await run(
    packageCommand('@playwright/test', ['test', '--reporter=list,json'], 'playwright'),
  );
  const counts = { ...noTests };
  if (existsSync(file)) {
    const { stats } = readJson(file);
    counts.passed = stats.expected;
    counts.failed = stats.unexpected + stats.flaky;
    counts.skipped = stats.skipped;
  }
  finishTests('e2e', status, seconds, counts);
}

/**
 * @param {string} name
 * @param {number} status
 * @param {number} seconds
 * @param {Counts} counts
 */
function finishTests(name, status, seconds, counts) {
  // Any other error (outside of all tests, or no report) counts as one failure.
  if (status !== 0 && counts.failed === 0) counts.failed = 1;
  const { passed, failed, skipped } = counts;
  const note = `${passed} passed, ${failed} failed, ${skipped} skipped`;
  /** @type {Result} */
  const done = { ...result(name, seconds), state: failed === 0 ? 'ok' : 'failed', note, counts };
  results.push(done);
  console.log(line(done));
}

/**
 * @param {string} name
 * @param {number} seconds
 * @returns {Result}
 */
function result(name, seconds) {
  return { name, state: 'ok', seconds, note: '', counts: noTests };
}

/** @param {string} name */
function reportFile(name) {
  const file = path.join(cacheFolder, `tests-${name}.json`);
  rmSync(file, { force: true });
  return file;
}

/**
 * Runs a command. Its output is shown, or returned if `quiet`.
 * @param {string[]} command
 * @param {{ quiet?: boolean, environment?: Record<string, string> }} [options]
 * @returns {Promise<Outcome>}
 */
function run([program = '', ...words], { quiet = false, environment = {} } = {}) {
  return new Promise((resolve) => {
    const begin = performance.now();
    const child = spawn(program, words, {
      cwd: root,
      env: { ...process.env, ...environment },
      stdio: ['ignore', quiet ? 'pipe' : 'inherit', quiet ? 'pipe' : 'inherit'],
      timeout: longestMinutes * 60_000,
    });
    running.add(child);
    let output = '';
    child.stdout?.setEncoding('utf8').on('data', (text) => (output += text));
    child.stderr?.setEncoding('utf8').on('data', (text) => (output += text));
    /** @param {number} status */
    const finish = (status) => {
      running.delete(child);
      resolve({ status, output, seconds: (performance.now() - begin) / 1000 });
    };
    child.once('error', (error) => {
      output += error.message;
      finish(1);
    });
    child.once('close', (code) => finish(code ?? 1));
  });
}

function report() {
  const total = { ...noTests };
  for (const { counts } of results) {
    total.passed += counts.passed;
    total.failed += counts.failed;
    total.skipped += counts.skipped;
  }
  console.log('\nSummary');
  for (const each of results) console.log(line(each));
  const seconds = ((performance.now() - started) / 1000).toFixed(1);
  console.log(`  ${total.skipped} tests skipped, ${seconds} s in all\n`);
  console.log(`${total.passed} passed, ${total.failed} failed`);
  // A run in which no test ran proves nothing.
  const ranTests = results.some(({ name }) => name === 'unit' || name === 'e2e');
  process.exitCode = total.failed > 0 || (ranTests && total.passed === 0) ? 1 : 0;
}

/** @param {Result | undefined} each */
function line(each) {
  if (each === undefined) return '';
  const { name, state, seconds, note } = each;
  return `  ${state.padEnd(8)}${name.padEnd(12)}${seconds.toFixed(1).padStart(6)} s  ${note}`.trimEnd();
}

/** @param {string} text */
function indent(text) {
  return text.trimEnd().replace(/^/gm, '    ');
}
