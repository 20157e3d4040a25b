import type { Actor } from '../document/scene.ts';
import type { PlaceTool } from '../document/session.ts';

/** The steps with Ctrl or Cmd, and of the arrow keys: scene units, radians, a part of the size. */
export const placeSteps: Readonly<Record<PlaceTool, number>> = {
  move: 0.1,
  turn: Math.PI / 12,
  scale: 0.1,
};

/** The steps as text. */
export const stepTexts: Readonly<Record<PlaceTool, string>> = {
  move: '0.1',
  turn: '15°',
  scale: '0.1',
};

const verbs: Readonly<Record<PlaceTool, string>> = { move: 'Move', turn: 'Turn', scale: 'Scale' };

/** The name of the step of undo. */
export function placeLabel(tool: PlaceTool, { name }: Pick<Actor, 'name'>): string {
  return `${verbs[tool]} ${name}`;
}
