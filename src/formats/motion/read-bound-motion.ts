import type { Diagnostic } from '../../core/diagnostics.ts';
import { type AnimatedThing, slotOf } from '../../core/motion/targets.ts';
import { readAnim } from '../cse169/anim.ts';
import { bindChannels } from '../cse169/bind-channels.ts';
import { extensionOf } from '../file-entry.ts';
import { bindMotion, type BoundMotion } from './bind-motion.ts';
import { atMost } from './largest-between.ts';
import { readMotion } from './read-motion.ts';
import { type ReorderedAngles, reorderAngles } from './reorder-angles.ts';

/** Reads a MOTION.json, or an `.anim` by its extension, for a character. */
export function readBoundMotion(
  file: string,
  bytes: Uint8Array,
  thing: AnimatedThing,
): BoundMotion {
  if (extensionOf(file) === '.anim') return readBoundAnim(file, bytes, thing);
  const read = readMotion(file, bytes);
  if (!read.value) return { diagnostics: read.diagnostics };
  const bound = bindMotion(read.value, thing);
  return { ...bound, diagnostics: [...read.diagnostics, ...bound.diagnostics] };
}

function readBoundAnim(file: string, bytes: Uint8Array, thing: AnimatedThing): BoundMotion {
  const read = readAnim(file, bytes);
  if (!read.value) return { diagnostics: read.diagnostics };
  const bound = bindChannels(read.value, thing.skeleton.jointCount);
  const diagnostics = [...read.diagnostics, ...bound.diagnostics];
  if (!bound.value) return { diagnostics };
  const still = bound.value.channels.filter(
    ({ target, keys }) => target && !slotOf(target, thing) && keys.some(({ value }) => value !== 0),
  );
  if (still.length > 0) diagnostics.push(movesNothing(file, still.length));
  const reordered = reorderAngles(bound.value, thing.skeleton);
  diagnostics.push(...orderDiagnostics(file, reordered));
  return { value: reordered.clip, diagnostics };
}

function orderDiagnostics(
  file: string,
  { joints, leftOut, largest }: ReorderedAngles,
): readonly Diagnostic[] {
  const degrees = atMost((largest * 180) / Math.PI);
  const base = { code: 'anim/order', file, expected: 'joints that turn by Rz · Ry · Rx' } as const;
  const sampled: Diagnostic = {
    ...base,
    severity: 'warning',
    found: `${joints} that turn in another order`,
    effect: `their rotations are sampled at frames as angles of their own order; off by at most ${degrees}° between them`,
  };
  const long: Diagnostic = {
    ...base,
    severity: 'error',
    found: `${leftOut} that turn in another order, over more frames than can be sampled`,
    effect: 'they do not move',
  };
  return [...(joints > 0 ? [sampled] : []), ...(leftOut > 0 ? [long] : [])];
}

function movesNothing(file: string, count: number): Diagnostic {
  return {
    severity: 'warning',
    code: 'anim/ignored',
    file,
    expected: 'joints that turn about x, y and z, each by an angle',
    found: `${count} channels for others`,
    effect: 'these channels move nothing',
  };
}
