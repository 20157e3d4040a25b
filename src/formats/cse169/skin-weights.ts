import { growFloat32, growUint16, growUint32 } from '../text/growable.ts';
import { PlainWeights } from './plain-weights.ts';
import type { Scanner } from './scanner.ts';
import { closeRows, endsEarly } from './sections.ts';

export interface SkinWeights {
  /** (pointCount + 1) */
  readonly start: Uint32Array;
  /** (pointCount) one-based line of each row. */
  readonly lines: Uint32Array;
  readonly joints: Uint16Array;
  readonly weights: Float32Array;
}

/**
 * Reads `N { k joint weight … }`: a row per vertex with any number of influences. If a row names a
 * joint twice, the two weights are added.
 */
export function readSkinWeights(
  scanner: Scanner,
  mostRows: number,
  mostJoints: number,
): SkinWeights | undefined {
  const count = scanner.count('rows of skinweights', 2, mostRows);
  if (!scanner.sound()) return undefined;
  const opened = scanner.openIfAny();
  const start = growUint32(count + 1);
  const joints = growUint16();
  const weights = growFloat32();
  const lines = growUint32(count);
  const plain = new PlainWeights(mostJoints, scanner.limits.weight, {
    start,
    lines,
    joints,
    weights,
  });
  start.push(0);
  for (let point = 0; point < count; point++) {
    scanner.takePlain((numbers) => {
      while (point < count && plain.readRow(numbers)) point++;
    });
    if (point === count) break;
    if (endsEarly(scanner, 'skinweights', count, point)) return undefined;
    readRow(point);
    if (!scanner.sound()) return undefined;
    start.push(weights.length);
  }
  if (!closeRows(scanner, 'skinweights', count, opened)) return undefined;
  return {
    start: start.finish(),
    lines: lines.finish(),
    joints: joints.finish(),
    weights: weights.finish(),
  };

  function readRow(point: number): void {
    const influenceCount = scanner.count(`influences of vertex ${point}`, 4, mostJoints);
    lines.push(scanner.reader.line);
    const row = new Map<number, number>();
    for (let i = 0; i < influenceCount && scanner.sound(); i++) {
      const joint = scanner.index(`a joint of vertex ${point}`, mostJoints - 1);
      if (!scanner.sound()) return;
      if (row.has(joint)) {
        const expected = `each joint once for vertex ${point}`;
        const effect = 'its weights are added up, here and in further rows';
        scanner.warnOnce('twice', 'duplicate', expected, `joint ${joint} again`, effect);
      }
      const weight = scanner.number(`a weight of vertex ${point}`, scanner.limits.weight);
      row.set(joint, (row.get(joint) ?? 0) + weight);
    }
    for (const [joint, weight] of row) {
      joints.push(joint);
      weights.push(weight);
    }
  }
}
