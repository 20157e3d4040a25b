/**
 * `npm start` installs what is missing, then serves the app from its sources and opens it. Words
 * after `--` go to Vite: `npm start -- --port 8080`, `npm start -- --open` or `--no-open`.
 */
import { pathToFileURL } from 'node:url';
import { packageCommand, root } from './commands.mjs';
import { install } from './install.mjs';

const words = process.argv.slice(2);

try {
  install();
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exit(1);
}

if (!words.some((word) => /^--(no-)?open\b/.test(word)) && hasScreen()) words.push('--open');

// Vite runs in this process, so that signals need no forwarding.
const [program = '', script = '', ...rest] = packageCommand('vite', words);
process.chdir(root);
process.argv = [program, script, ...rest.filter((word) => word !== '--no-open')];
await import(pathToFileURL(script).href);

/** Whether the machine has a screen on which a browser could open. */
function hasScreen() {
  const { env } = process;
  if (env['CI'] || env['SSH_CONNECTION'] || !process.stdout.isTTY) return false;
  if (process.platform === 'win32' || process.platform === 'darwin') return true;
  return Boolean(env['DISPLAY'] || env['WAYLAND_DISPLAY']);
}
