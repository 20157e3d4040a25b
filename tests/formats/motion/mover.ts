import { buildCharacter } from '../../../src/core/build-character.ts';
import type { AnimatedThing } from '../../../src/core/motion/targets.ts';
import { DofKind } from '../../../src/core/skeleton.ts';

const axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;
const slides = axes.map((axis) => ({ kind: DofKind.slide, axis }));
const hinges = axes.map((axis) => ({ kind: DofKind.hinge, axis }));
const ball = { kind: DofKind.ball, axis: [0, 0, 0] as const };

const joints = [
  { name: 'root', parent: -1, restOffset: [0, 1, 0] as const, dofs: [...slides, ...hinges] },
  { name: 'elbow', parent: 0, restOffset: [1, 0, 0] as const, dofs: hinges },
  { name: 'neck', parent: 0, restOffset: [0, 1, 0] as const, dofs: [ball] },
  { name: 'wrist', parent: 1, restOffset: [1, 0, 0] as const, dofs: [hinges[0]!] },
];

const { skeleton } = buildCharacter({
  name: 'mover',
  missing: [],
  skeleton: { file: 'mover.skel', joints },
}).value!;

/** A character with a joint of every kind, and with morphs of clear and of unclear names. */
export const mover: AnimatedThing = {
  skeleton,
  morphs: [{ name: 'smile' }, { name: 'twin' }, { name: 'twin' }, { name: '#0' }],
};
