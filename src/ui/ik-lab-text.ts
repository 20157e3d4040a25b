import { jointOfValue } from '../core/pose.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import { type LabChain, pathPlaces } from '../posing/ik/lab-chain.ts';
import type { EllipsoidAxis } from '../posing/ik/lab-ellipsoid.ts';
import { numberOf } from '../posing/ik/lab.ts';
import type { TargetKind } from '../posing/ik/lab-targets.ts';
import type { IkStatus } from '../posing/ik/problem.ts';
import { formatDegrees } from './angle-text.ts';
import type { MethodRun } from './ik-lab.ts';
import { jointValues, valueName } from './joint-values.ts';
import { formatSize } from './number-text.ts';

/** From this part of a chain's length on, its effector is as far away as on a straight limb. */
const straightPart = 0.995;
/** A direction is nearly lost where turns move the effector by less than this part of the best one. */
const lostPart = 0.1;

/** The kinds of targets in the order of their buttons, and what there is to see. */
export const targetKinds: readonly {
  readonly id: TargetKind;
  readonly label: string;
  readonly note: string;
}[] = [
  {
    id: 'reachable',
    label: 'Reachable',
    note: 'Another pose within the limits brings the joint there.',
  },
  {
    id: 'far',
    label: 'Too far',
    note: 'It is farther away than the limb is long. The limb should stretch and come to rest.',
  },
  {
    id: 'close',
    label: 'Too close',
    note: 'The limb has to fold, as far as the lengths of its bones and its limits allow.',
  },
  {
    id: 'straight',
    label: 'Straight limb',
    note: 'It starts stretched out, and the target lies on its line: no small turn leads there.',
  },
];

/** A residual as a part of the chain's length, with two digits: "0.12 %". */
export function partText(part: number): string {
  const percent = part * 100;
  if (percent === 0) return '0 %';
  return percent < 1e-4 ? 'under 0.0001 %' : `${Number(percent.toPrecision(2))} %`;
}

const endings: Readonly<Record<IkStatus, string>> = {
  reached: 'reached it',
  'out-of-reach': 'found it out of reach',
  limits: 'met limits',
  stalled: 'stalled',
};

/** How a method ends: "reached it after 4 steps, with 0.02 % left." */
export function endText(run: MethodRun): string {
  const { solution, steps } = run;
  const count = numberOf(run, steps.length - 1);
  const counted = count === 1 ? '1 step' : `${count} steps`;
  const left = partText(steps.at(-1)!.error);
  return `${endings[solution.status]} after ${counted}, with ${left} left.`;
}

/** What a limit that is met keeps: "Left elbow X is at its upper limit, 140.0°." */
export function limitText(skeleton: Skeleton, q: Float64Array, index: number): string {
  const joint = jointOfValue(skeleton, index);
  const value = jointValues(skeleton, joint).find((each) => each.index === index);
  const name = `${skeleton.names[joint]!}${value ? ` ${valueName(value)}` : ''}`;
  const [least, most] = [skeleton.qMin[index]!, skeleton.qMax[index]!];
  const isUpper = most - q[index]! < q[index]! - least;
  const limit = isUpper ? most : least;
  const dof = skeleton.dofQ.indexOf(index);
  const isAngle = skeleton.dofKind[dof] === DofKind.hinge;
  const text = isAngle ? formatDegrees(limit) : formatSize(limit);
  return `${name} is at its ${isUpper ? 'upper' : 'lower'} limit, ${text}.`;
}

/** The longest axis of an ellipsoid over the shortest, or null if it has no extent. */
export function conditionOf(ellipsoid: readonly EllipsoidAxis[]): number | null {
  const [longest, shortest] = [ellipsoid[0]?.size ?? 0, ellipsoid.at(-1)?.size ?? 0];
  return longest > 0 ? longest / shortest : null;
}

/** "12", or "over 1000" for what is singular but for rounding. */
export function conditionText(condition: number): string {
  return condition > 1000 ? 'over 1000' : formatSize(condition);
}

/** What it means for the joint that the ellipsoid is flat, or '' where it is not. */
export function flatnessText(
  chain: LabChain,
  q: Float64Array,
  ellipsoid: readonly EllipsoidAxis[],
): string {
  const condition = conditionOf(ellipsoid);
  if (condition === null || condition < 1 / lostPart) return '';
  const name = chain.skeleton.names[chain.path.at(-1)!]!;
  const places = pathPlaces(chain, q);
  const [root, end] = [places[0]!, places.at(-1)!];
  const away = Math.hypot(end[0] - root[0], end[1] - root[1], end[2] - root[2]);
  if (away >= straightPart * chain.length) {
    return `The limb is almost straight: no small turn brings ${name} nearer along it.`;
  }
  const lost = ellipsoid.filter(({ size }) => size <= lostPart * ellipsoid[0]!.size).length;
  return lost > 1
    ? `In this pose small turns move ${name} along one line alone.`
    : `In this pose small turns move ${name} in one plane, and hardly out of it.`;
}
