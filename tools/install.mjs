/**
 * Installs the packages of package-lock.json that are missing or have another version, and returns
 * quickly if all are in place. Every command runs it, so that a fresh clone needs no separate
 * install. It reports on standard error, because standard output belongs to the command.
 */
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import path from 'node:path';
import { isMain, npmCommand, readJson, root } from './commands.mjs';

/** @typedef {{ version?: string, integrity?: string, optional?: boolean, link?: boolean }} Locked */

const oldestNode = [20, 19];

/**
 * Installs what is missing. If that fails, it throws an error with a message for the user.
 * @param {string} [folder] which has a package-lock.json
 */
export function install(folder = root) {
  checkNode();
  const reason = whyInstall(folder);
  if (reason === undefined) return;
  console.error(`install: ${reason}; running npm ci`);
  const [program = '', ...words] = npmCommand(['ci', '--no-audit', '--no-fund']);
  const started = performance.now();
  const { status, error } = spawnSync(program, words, {
    cwd: folder,
    stdio: ['ignore', 2, 2],
  });
  if (error) throw new Error(`install: npm could not be started (${error.message})`);
  if (status !== 0) throw new Error('install: npm ci failed; its message is above');
  console.error(`install: done in ${((performance.now() - started) / 1000).toFixed(1)} s`);
}

function checkNode() {
  const [major = 0, minor = 0] = process.versions.node.split('.').map(Number);
  const [oldestMajor = 0, oldestMinor = 0] = oldestNode;
  if (major > oldestMajor || (major === oldestMajor && minor >= oldestMinor)) return;
  throw new Error(
    `Sinew needs Node ${oldestNode.join('.')} or newer; this is ${process.versions.node}. ` +
      'Install the current long-term version from nodejs.org, or with a version manager ' +
      '(nvm install --lts).',
  );
}

/**
 * Returns the first reason to install, or undefined. npm records what it installed in a file of the
 * same form as the lock file, and writes it last. The contents of the two are compared, because the
 * times of files change with every checkout.
 * @param {string} folder
 * @returns {string | undefined}
 */
function whyInstall(folder) {
  const recordFile = path.join(folder, 'node_modules/.package-lock.json');
  if (!existsSync(recordFile)) return 'the packages are not installed';
  /** @type {Record<string, Locked>} */
  const installed = readJson(recordFile).packages;
  /** @type {Record<string, Locked>} */
  const locked = readJson(path.join(folder, 'package-lock.json')).packages;
  for (const [place, wanted] of Object.entries(locked)) {
    if (place === '') continue;
    const found = installed[place];
    const name = place.replace(/^.*node_modules\//, '');
    if (found === undefined) {
      // npm leaves out optional packages for other systems.
      if (wanted.optional !== true) return `${name} is not installed`;
    } else if (found.version !== wanted.version || found.integrity !== wanted.integrity) {
      return `${name} is installed in another version`;
    }
  }
  const surplus = Object.keys(installed).find((place) => locked[place] === undefined);
  return surplus === undefined ? undefined : `${surplus} is installed but not wanted`;
}

if (isMain(import.meta.url)) {
  try {
    install();
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
    process.exitCode = 1;
  }
}
