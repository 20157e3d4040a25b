import { mat3, mat4, quat, vec3 } from 'gl-matrix';
import { noParent } from '../../core/skeleton.ts';
import type { CuttingPlane } from '../../document/cutting.ts';
import type { Vector3 } from '../../posing/ik/problem.ts';
import { bendAxis, limbEnd } from '../../posing/telling-poses.ts';
import { turnStart } from '../../posing/turn-joint.ts';
import type { Evaluation } from '../evaluation.ts';

/** How a plane lies: along the bone and its bend, across the bone, or facing the camera. */
export type PlaneDirection = 'along' | 'across' | 'camera';

/** How a plane is placed at a joint. */
export interface PlanePlace {
  readonly joint: number;
  readonly direction: PlaneDirection;
  /** Radians about the bone; of a plane across it about the axis of the bend, else upright. */
  readonly turn: number;
  /** Along the normal, as a part of the plane's reach. */
  readonly offset: number;
}

/** From the viewer's side, in the character's space; unit vectors. */
export interface Facing {
  readonly toViewer: Vector3;
  readonly up: Vector3;
}

/** Bones whose angle has a smaller sine are straight, and do not tell how they bend. */
const leastBend = 0.1;
/** A plane that lies flatter than by this cosine is drawn with another axis upwards. */
const flat = 0.9;

/** Returns the plane of a figure at a joint of a posed character. */
export function cuttingPlane(
  evaluation: Evaluation,
  { joint, direction, turn, offset }: PlanePlace,
  facing: Facing,
): CuttingPlane {
  const matrix = evaluation.characterFromJoint.subarray(joint * 16, joint * 16 + 16);
  const at = mat4.getTranslation(new Float64Array(3), matrix);
  const rotation = mat3.fromMat4(new Float64Array(9), matrix);
  const bone = vec3.transformMat3(
    new Float64Array(3),
    limbEnd(evaluation.state.character, joint),
    rotation,
  );
  const before = boneBefore(evaluation, joint, at);
  const reach = Math.max(vec3.length(bone), vec3.length(before)) || 1;
  if (vec3.length(bone) === 0) vec3.copy(bone, vec3.length(before) > 0 ? before : [0, 1, 0]);
  vec3.normalize(bone, bone);
  vec3.normalize(before, before);
  const axis = axisOfBend(evaluation, joint, before, bone);
  const poses = {
    along: { normal: axis, about: bone },
    across: { normal: bone, about: axis },
    camera: { normal: facing.toViewer, about: facing.up },
  };
  const { normal: unturned, about } = poses[direction];
  const normal: vec3 = new Float64Array(3);
  const turned = quat.setAxisAngle(new Float64Array(4), about, turn);
  vec3.normalize(normal, vec3.transformQuat(normal, unturned, turned));
  const up = upIn(normal, direction === 'camera' ? facing.up : null);
  const across = vec3.cross(new Float64Array(3), up, normal);
  const origin = vec3.scaleAndAdd(new Float64Array(3), at, normal, offset * reach);
  return {
    origin: tuple(origin),
    across: tuple(across),
    up: tuple(up),
    normal: tuple(normal),
    reach,
  };
}

/** From the nearest joint above that is at another place; zero if there is none. */
function boneBefore({ state, characterFromJoint }: Evaluation, joint: number, at: vec3): vec3 {
  const { parents } = state.character.skeleton;
  const from: vec3 = new Float64Array(3);
  for (let above = parents[joint]!; above !== noParent; above = parents[above]!) {
    mat4.getTranslation(from, characterFromJoint.subarray(above * 16, above * 16 + 16));
    if (vec3.distance(at, from) > 1e-8) return vec3.subtract(from, at, from);
  }
  return new Float64Array(3);
}

/** The axis about which the bones are bent now, or else about which the joint would bend. */
function axisOfBend(evaluation: Evaluation, joint: number, before: vec3, bone: vec3): vec3 {
  const { state, pose } = evaluation;
  const { skeleton } = state.character;
  const usual = vec3.clone(bendAxis(state.character, joint, turnStart(skeleton, joint, pose.q)));
  const shown = vec3.cross(new Float64Array(3), before, bone);
  if (vec3.length(shown) < leastBend) {
    // A plane along the bone has its normal at a right angle to it.
    vec3.scaleAndAdd(shown, usual, bone, -vec3.dot(usual, bone));
  }
  // It keeps its side, so that the figure does not turn over while the joint goes through straight.
  if (vec3.dot(shown, usual) < 0) vec3.negate(shown, shown);
  return vec3.normalize(shown, shown);
}

/** The direction in a plane that is drawn upwards: the character's, or the camera's. */
function upIn(normal: vec3, wanted: Vector3 | null): vec3 {
  const up = wanted ?? (Math.abs(normal[1]) < flat ? [0, 1, 0] : [0, 0, -1]);
  const inPlane = vec3.scaleAndAdd(new Float64Array(3), up, normal, -vec3.dot(up, normal));
  return vec3.normalize(inPlane, inPlane);
}

function tuple(vector: vec3): Vector3 {
  return [vector[0], vector[1], vector[2]];
}
