import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { promisify } from 'node:util';

const root = path.join(import.meta.dirname, '..');
const compiler = path.join(root, 'node_modules/assemblyscript/bin/asc.js');

/** The kernel in AssemblyScript. */
export const kernelFile = path.join(root, 'src/skinning/wasm/kernel.as');

const plainOptions = ['--noAssert', '--runtime', 'stub', '--importMemory', '--enable', 'simd'];

/**
 * Compiles the skinning kernel to WebAssembly. The result is kept in .cache under the hash of
 * everything that determines it, so that a kernel is compiled once. Rejects with the compiler's
 * messages if the source is not valid.
 *
 * @param source the kernel's text
 * @param optimizeLevel from 0 to 3; it changes no bit of what the kernel computes
 */
export async function compileKernel(
  source = readFileSync(kernelFile, 'utf8'),
  optimizeLevel = 3,
): Promise<Uint8Array<ArrayBuffer>> {
  const options = ['--optimizeLevel', `${optimizeLevel}`, ...plainOptions];
  const { devDependencies } = JSON.parse(readFileSync(path.join(root, 'package.json'), 'utf8')) as {
    devDependencies: { assemblyscript: string };
  };
  const determined = [source, devDependencies.assemblyscript, ...options].join('\n');
  const hash = createHash('sha256').update(determined).digest('hex').slice(0, 16);
  const folder = path.join(root, '.cache/wasm');
  const file = path.join(folder, `${hash}.wasm`);
  try {
    return new Uint8Array(readFileSync(file));
  } catch {
    mkdirSync(folder, { recursive: true });
    // Several processes may do this at once, so each writes files of its own first.
    const [text, made] = [`${hash}-${process.pid}.ts`, `${hash}-${process.pid}.wasm`];
    writeFileSync(path.join(folder, text), source);
    const words = [compiler, text, '--outFile', made, ...options];
    try {
      await promisify(execFile)(process.execPath, words, { cwd: folder });
    } finally {
      rmSync(path.join(folder, text));
    }
    renameSync(path.join(folder, made), file);
    return new Uint8Array(readFileSync(file));
  }
}
