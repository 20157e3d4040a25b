import { axisDofs } from '../../core/pose.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { encodeLines, writeFloat32, writeFloat64 } from '../text/write-number.ts';

/**
 * Writes a `balljoint` skeleton with the joints depth first: offset, box and limits if there are
 * any, and the file's pose.
 */
export function writeSkel(skeleton: Skeleton): Uint8Array {
  const lines: string[] = [];
  const names = writtenNames(skeleton);
  let open = 0;
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    closeTo(skeleton.depths[joint]!);
    const indent = '\t'.repeat(open++);
    lines.push(`${indent}balljoint ${names[joint]!}`.trimEnd() + ' {');
    for (const line of properties(skeleton, joint)) lines.push(`${indent}\t${line}`);
  }
  closeTo(0);
  return encodeLines(lines);

  function closeTo(depth: number): void {
    while (open > depth) lines.push(`${'\t'.repeat(--open)}}`);
  }
}

/**
 * Returns names that the file can hold, one word each. If the source file had names, joints without
 * one stay nameless; a skeleton of another format has its display names.
 */
export function writtenNames({ names, fileNames }: Skeleton): string[] {
  const own = fileNames.some((name) => name !== '');
  return (own ? fileNames : names).map(oneWord);
}

/** Replaces white space, braces and the characters that start a comment. */
export function oneWord(name: string): string {
  return name.replace(/[\s{}]+/g, '_').replace(/^(#|\/\/|\/\*)/, '_');
}

function properties(skeleton: Skeleton, joint: number): string[] {
  const lines = [`offset ${numbers(skeleton.restOffsets.subarray(joint * 3, joint * 3 + 3))}`];
  const box = skeleton.displayBoxes?.subarray(joint * 6, joint * 6 + 6);
  if (box) {
    lines.push(`boxmin ${floats(box.subarray(0, 3))}`);
    lines.push(`boxmax ${floats(box.subarray(3))}`);
  }
  const pose = [0, 0, 0];
  const limits: string[] = [];
  for (const { kind, axis, index } of axisDofs(skeleton, joint)) {
    if (kind !== DofKind.hinge) continue;
    pose[axis] = skeleton.qRest[index]!;
    const range = [skeleton.qMin[index]!, skeleton.qMax[index]!];
    if (range.every(Number.isFinite)) limits[axis] = `rot${'xyz'[axis]!}limit ${numbers(range)}`;
  }
  return [...lines, ...limits.filter((line) => line !== ''), `pose ${numbers(pose)}`];
}

function floats(values: Float32Array): string {
  return Array.from(values, writeFloat32).join(' ');
}

function numbers(values: ArrayLike<number>): string {
  return Array.from(values, writeFloat64).join(' ');
}
