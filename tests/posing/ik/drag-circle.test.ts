import { expect, it } from 'vitest';
import { dls } from '../../../src/posing/ik/dls.ts';
import { goalChains } from '../../../src/posing/ik/goal-chains.ts';
import type { JointNature, Vector3 } from '../../../src/posing/ik/problem.ts';
import { naturesOf } from '../../../src/posing/natural/natures.ts';
import { readBundled } from '../../support/bundled.ts';
import { play, turnsBetween } from './drag-path.ts';
import { goalAt, goalsAt, type IkRig, problemOf, sixBalls } from './ik-rigs.ts';

const frameRate = 60;
/** In radians a frame. */
const step = (2 * Math.PI) / 180;

async function humanArm(): Promise<{ rig: IkRig; natures: readonly JointNature[] }> {
  const human = await readBundled('human');
  const { skeleton } = human;
  const at = (name: string): number => skeleton.names.indexOf(name);
  const joints = ['Right shoulder', 'Right upper arm', 'Right forearm'].map(at);
  const goals = [goalAt(at('Right hand'), [0, 0, 0])];
  const rig = { skeleton, goals, joints, rangeOf: () => [0, 0] as const, start: skeleton.qRest };
  return { rig, natures: naturesOf(human) };
}

it.each(['six balls', 'the arm of the human', 'the same arm by nature'])(
  'a hand that circles at 1.5 times the reach turns no joint by more than 5° in a frame: %s',
  async (name) => {
    const human = await humanArm();
    const rig = name === 'six balls' ? sixBalls() : human.rig;
    const natures = name === 'the same arm by nature' ? human.natures : [];
    const { skeleton, start } = rig;
    const [goal] = goalsAt(rig, start);
    const { root, reach } = goalChains(problemOf(rig, [goal!]))[0]!;
    const circle = (seconds: number): Vector3 => {
      const angle = seconds * frameRate * step;
      const [x, y, z] = root;
      const radius = 1.5 * reach;
      return [
        x - radius * Math.cos(angle),
        y + radius * Math.sin(angle) * 0.8,
        z + radius * Math.sin(angle) * 0.6,
      ];
    };
    const count = rig.joints.length + (goal!.joint === rig.joints.at(-1) ? 0 : 1);
    const { joint, point } = goal!;
    const drag = {
      skeleton,
      q: start,
      joint,
      point,
      count,
      held: [],
      natures,
      seconds: 0,
      solver: dls,
    };
    const { moments } = play(drag, circle, (2 * Math.PI) / step / frameRate, frameRate);
    expect(moments.length).toBeGreaterThan(180);
    moments.slice(1).forEach(({ q }, frame) => {
      expect(Math.max(...turnsBetween(skeleton, moments[frame]!.q, q))).toBeLessThan(5);
    });
  },
);
