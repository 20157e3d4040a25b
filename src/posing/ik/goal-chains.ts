import { jointMatrices } from '../../core/forward-kinematics.ts';
import { DofKind, noParent } from '../../core/skeleton.ts';
import type { IkProblem } from './problem.ts';

/** The joints that can bring a goal's point to its target. */
export interface GoalChain {
  /** The joints of the problem at or above the goal's joint, the outermost first. */
  readonly joints: readonly number[];
  /** The origin of the outermost joint's frame at rest, in the character's space. */
  readonly root: readonly [number, number, number];
  /** How far the point can be from the root; infinite if a slide has no limits. */
  readonly reach: number;
  /**
   * The length by which residuals are measured: the reach without slides, or 1 if that is zero,
   * because something slides but nothing turns.
   */
  readonly length: number;
}

/**
 * Finds the chain of every goal. Consecutive joints of the chain are rigidly connected, except for
 * their slides, so their distances in the reference pose are the lengths of its links.
 */
export function goalChains({ skeleton, goals, joints, reference }: IkProblem): GoalChain[] {
  const characterFromJoint = jointMatrices(skeleton, reference);
  const canMove = new Set(joints.filter((joint) => moves(joint)));
  return goals.map((goal) => {
    const chain: number[] = [];
    for (let joint = goal.joint; joint !== noParent; joint = skeleton.parents[joint]!) {
      if (canMove.has(joint)) chain.unshift(joint);
    }
    const point = transformed(goal.joint, goal.point);
    const root = restOrigin(chain[0] ?? goal.joint);
    const places = [root, ...chain.map((joint) => transformed(joint, [0, 0, 0])), point];
    let length = 0;
    for (let i = 1; i < places.length; i++) length += distance(places[i - 1]!, places[i]!);
    // A slide lengthens its chain by at most its range, wherever in the range it is now.
    const slides = chain.reduce((sum, joint) => sum + slideRange(joint), 0);
    return {
      joints: chain,
      root,
      reach: length + slides,
      length: length > 0 ? length : 1,
    };
  });

  function moves(joint: number): boolean {
    for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
      const value = skeleton.dofQ[dof]!;
      const isBall = skeleton.dofKind[dof] === DofKind.ball;
      if (isBall || skeleton.qMin[value]! < skeleton.qMax[value]!) return true;
    }
    return false;
  }

  function slideRange(joint: number): number {
    let range = 0;
    for (let dof = skeleton.dofStart[joint]!; dof < skeleton.dofStart[joint + 1]!; dof++) {
      if (skeleton.dofKind[dof] !== DofKind.slide) continue;
      const value = skeleton.dofQ[dof]!;
      range += skeleton.qMax[value]! - skeleton.qMin[value]!;
    }
    return range;
  }

  function transformed(joint: number, [x, y, z]: readonly number[]): [number, number, number] {
    const m = characterFromJoint.subarray(joint * 16, joint * 16 + 16);
    const row = (r: number): number => m[r]! * x! + m[4 + r]! * y! + m[8 + r]! * z! + m[12 + r]!;
    return [row(0), row(1), row(2)];
  }

  function restOrigin(joint: number): [number, number, number] {
    const [x, y, z] = skeleton.restOffsets.subarray(joint * 3, joint * 3 + 3);
    const parent = skeleton.parents[joint]!;
    return parent === noParent ? [x!, y!, z!] : transformed(parent, [x!, y!, z!]);
  }
}

function distance(a: readonly number[], b: readonly number[]): number {
  return Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
}
