import { vec3 } from 'gl-matrix';
import type { Transform } from '../document/scene.ts';
import type { PlaceAxes, PlaceTool } from '../document/session.ts';
import { angleBetween } from '../document/place-edits.ts';
import { axisOf, type PlaceHandle } from '../view/place-gizmo.ts';
import { formatDegrees } from './angle-text.ts';
import { axisNames } from './joint-values.ts';
import { fixedText } from './number-text.ts';
import { stepTexts } from './place-steps.ts';

const axisIndices = [0, 1, 2] as const;

/** What a drag of a handle has done: "Moved X 0.300", "Turned Y 15°", "Size 1.200". */
export function dragText(
  { kind, axis, direction }: Pick<PlaceHandle, 'kind' | 'axis' | 'direction'>,
  axes: PlaceAxes,
  from: Transform,
  to: Transform,
): string {
  if (kind === 'size') return `Size ${fixedText(to.scale)}`;
  const own = axes === 'local' && axis !== null ? 'its own ' : '';
  if (kind === 'ring') {
    const angle = angleBetween(from, to, direction);
    return `Turned ${own}${axisNames[axis!]} ${formatDegrees(angle)}`;
  }
  const by = vec3.subtract(new Float64Array(3), [...to.position], [...from.position]);
  // A line moves along its axis, a plane along the two others, and the view's plane along all.
  const moved = axisIndices.filter(
    (each) => axis === null || (kind === 'line') === (each === axis),
  );
  const amounts = moved.map((each) => {
    const unit = axisOf(from, axis === null ? 'world' : axes, each);
    return `${axisNames[each]} ${fixedText(vec3.dot(by, unit))}`;
  });
  return `Moved ${own}${amounts.join(', ')}`;
}

/** What the keys do during a drag with the mouse. */
export function stepHint(tool: PlaceTool, steps: boolean): string {
  const text = stepTexts[tool];
  return steps ? ` · in steps of ${text}` : ` · Ctrl/Cmd: steps of ${text}, Shift: a tenth`;
}
