import type { Skeleton } from '../../core/skeleton.ts';

export type Vector3 = readonly [number, number, number];
export type Quaternion = readonly [number, number, number, number];

/** A place, and optionally an orientation, that a joint is to have. */
export interface IkGoal {
  readonly joint: number;
  /** The point that is to reach the target, in the joint's frame; zero is the joint's origin. */
  readonly point: Vector3;
  /** In the character's space, model units. */
  readonly target: Vector3;
  /** `characterFromJoint` as a unit quaternion xyzw; any orientation will do if absent. */
  readonly rotation?: Quaternion;
  /** How much it counts against the other goals; 1 is a dragged point, and more is held harder. */
  readonly weight: number;
}

/**
 * How a joint moves by nature, beside the hard limits of its file. Its rotation from the joint's rest
 * (the product of its rotating degrees of freedom) is `swing · twist`: the twist is about the
 * limb, and the swing is a rotation vector across it.
 */
export interface JointNature {
  readonly joint: number;
  /** How much more it resists than a joint of stiffness 1, such as an elbow. */
  readonly stiffness: number;
  /**
   * Unit quaternion xyzw, from the nature's axes to the joint's frame at rest: x is the axis of
   * bending, y that of bending sideways, and z points along the limb.
   */
  readonly jointFromNature: Quaternion;
  /** Soft ranges in radians, which the solver leaves only where the goals demand it. */
  readonly bend: readonly [number, number];
  readonly side: readonly [number, number];
  readonly twist: readonly [number, number];
}

/** What inverse kinematics is to do. It is a value; solvers never write into it. */
export interface IkProblem {
  readonly skeleton: Skeleton;
  readonly goals: readonly IkGoal[];
  /** The joints whose values may change, ascending; the others keep those of `reference`. */
  readonly joints: readonly number[];
  /** (qCount) the pose that the null space pulls to, and from which a solve starts by default. */
  readonly reference: Float64Array;
  /** How the joints move by nature; empty for none. At most one entry a joint. */
  readonly natures: readonly JointNature[];
}

export interface IkOptions {
  /** (qCount) where to start; the reference if absent. */
  readonly from?: Float64Array;
  /** The most iterations of each start. */
  readonly iterations?: number;
  /** How many other starts are tried when a solve stalls within reach; 0 tries none. */
  readonly restarts?: number;
  /**
   * How far the solve may turn a joint from the start, in radians; infinite if absent. A drag passes
   * what looks like motion in one frame, so that a pose that has to change over, because its target
   * passed behind the body, swings there in place of jumping. It suits no restarts.
   */
  readonly mostTurn?: number;
  /** Whether the soft ranges of natures never give way, even if a goal within reach is missed so. */
  readonly keepsNatures?: boolean;
  /** Residuals below this fraction of a goal's chain count as zero. */
  readonly tolerance?: number;
}

/**
 * - `reached`: every residual is at most 1e-3 of its chain's length.
 * - `out-of-reach`: a target is farther from its chain's root than the chain is long.
 * - `limits`: a hard limit is active.
 * - `stalled`: none of these.
 */
export type IkStatus = 'reached' | 'limits' | 'out-of-reach' | 'stalled';

export interface IkSolution {
  /** (qCount) within the limits. Without an improvement it has exactly the bits of the start. */
  readonly q: Float64Array;
  /** (goals) the distance of each point from its target, in model units. */
  readonly residuals: readonly number[];
  /** (goals) the angle from each goal's orientation in radians, 0 where it has none. */
  readonly turns: readonly number[];
  readonly iterations: number;
  readonly status: IkStatus;
  /** The indices of q whose hard limits are active, ascending. */
  readonly atLimits: readonly number[];
}

/** One step of a method, for those who want to see how it works. */
export interface IkStep {
  readonly q: Float64Array;
  readonly residuals: readonly number[];
  /** What the method did, as a sentence: "Joint 3 turned by 12.0° about Z, which reached its limit." */
  readonly text: string;
  readonly atLimits: readonly number[];
  /** Of the Jacobian before the step, the largest first; empty for methods without one. */
  readonly singularValues: readonly number[];
}

export type IkMethodId = 'dls' | 'ccd' | 'fabrik';

/** A method of inverse kinematics as data; its code is loaded when it is first needed. */
export interface IkMethod {
  readonly id: IkMethodId;
  readonly label: string;
  /** What it does and where it falls short, in one or two sentences for the user. */
  readonly summary: string;
  readonly load: () => Promise<IkSolver>;
}

export interface IkSolver {
  solve(problem: IkProblem, options?: IkOptions): IkSolution;
  /** Yields the start and then each step; it takes the same way as `solve`. */
  steps(problem: IkProblem, options?: IkOptions): Generator<IkStep>;
}
