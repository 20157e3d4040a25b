import { readFileSync } from 'node:fs';
import type { Diagnostic, Parsed } from '../core/diagnostics.ts';
import type { AnimatedThing } from '../core/motion/targets.ts';
import { readAnim } from '../formats/cse169/anim.ts';
import { baseName, extensionOf } from '../formats/file-entry.ts';
import type { BoundMotion } from '../formats/motion/bind-motion.ts';
import { readBoundMotion } from '../formats/motion/read-bound-motion.ts';
import { readMotion } from '../formats/motion/read-motion.ts';
import {
  channelsOfAnim,
  channelsOfMotion,
  type SampledChannel,
} from '../formats/motion/sampled-channels.ts';
import { existingPath } from './existing-path.ts';
import { readFiles, unreadable, userPath } from './files.ts';

/**
 * Each channel with an error moves nothing, but a part of a motion is nothing to write in a script that
 * nobody watches.
 */
export const unusedMotion = 'error: nothing is written, because the motion has errors';

/**
 * Reads the channels of a MOTION.json or an `.anim`, which no character is needed for, by their
 * numbers in the file; undefined where one can't be used.
 */
export async function readChannels(
  path: string,
): Promise<Parsed<readonly (SampledChannel | undefined)[]>> {
  const { bytes, diagnostics } = await bytesOf(path);
  if (!bytes) return { diagnostics };
  if (isAnim(path)) {
    const read = readAnim(baseName(path), bytes);
    const channels = read.value && channelsOfAnim(read.value);
    return { diagnostics: read.diagnostics, ...(channels && { value: channels }) };
  }
  const read = readMotion(baseName(path), bytes);
  const channels = read.value && channelsOfMotion(read.value);
  return { diagnostics: read.diagnostics, ...(channels && { value: channels }) };
}

/** Reads a motion for a character. */
export async function readMotionFile(path: string, thing: AnimatedThing): Promise<BoundMotion> {
  const { bytes, diagnostics } = await bytesOf(path);
  return bytes ? readBoundMotion(baseName(path), bytes, thing) : { diagnostics };
}

function isAnim(path: string): boolean {
  return extensionOf(path.replace(/\.gz$/i, '')) === '.anim';
}

async function bytesOf(path: string): Promise<{
  readonly bytes?: Uint8Array;
  readonly diagnostics: readonly Diagnostic[];
}> {
  if (isAnim(path)) {
    const { files, diagnostics } = readFiles([path]);
    return files[0] ? { bytes: await files[0].bytes(), diagnostics } : { diagnostics };
  }
  try {
    return {
      bytes: new Uint8Array(readFileSync(existingPath(userPath(path)))),
      diagnostics: [],
    };
  } catch (error) {
    return { diagnostics: [unreadable(path, error)] };
  }
}
