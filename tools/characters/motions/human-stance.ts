import { mirrored, type Turn } from './curves.ts';

type Side = Readonly<Record<string, Turn>>;

/** The right arm, which hangs beside the body with a soft elbow and a loose hand. */
const rightArm: Side = {
  shoulder: [0, 0, 0.03],
  'upper arm': [0.03, 0.1, 0.55],
  forearm: [0.26, -0.3, 0.2],
  hand: [0.03, -0.05, 0.14],
  palm: [0.08, 0.1, 0.06],
  fingers: [0.13, 0.18, 0.1],
};

/** The right leg, straight, with the feet a little turned out. */
const rightLeg: Side = {
  'upper leg': [-0.02, -0.1, 0.03],
  'lower leg': [0.04, 0, 0],
  foot: [-0.02, 0, -0.03],
  toes: [0, 0, 0],
};

/** An upright, relaxed human. */
export const stance: Readonly<Record<string, Turn>> = {
  Hips: [0, 0, 0],
  'Lower back': [-0.02, 0, 0],
  Spine: [0, 0, 0],
  Chest: [0.03, 0, 0],
  Neck: [0.04, 0, 0],
  'Upper neck': [0, 0, 0],
  Head: [-0.05, 0, 0],
  ...onBothSides({ ...rightArm, ...rightLeg }),
};

/** Names the joints of the right side, and of the left one, which mirrors it. */
export function onBothSides(right: Side, left: Side = mirror(right)): Record<string, Turn> {
  const named = (side: string, turns: Side): [string, Turn][] =>
    Object.entries(turns).map(([name, turn]) => [`${side} ${name}`, turn]);
  return Object.fromEntries([...named('Right', right), ...named('Left', left)]);
}

function mirror(side: Side): Side {
  return Object.fromEntries(Object.entries(side).map(([name, turn]) => [name, mirrored(turn)]));
}
