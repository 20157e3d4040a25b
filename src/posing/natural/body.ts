import { vec3 } from 'gl-matrix';
import { bonesOf } from '../../core/bones.ts';
import type { Character } from '../../core/character.ts';
import { jointMatrices } from '../../core/forward-kinematics.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import type { Side } from '../symmetry/name-sides.ts';
import { namedRoles } from './name-roles.ts';
import type { JointRole } from './roles.ts';
import { shapedRoles } from './shape-roles.ts';

/**
 * A character as a body: what its joints are, and how it stands where all its degrees of freedom
 * are zero. Vectors are in the character's space.
 */
export interface Body {
  readonly skeleton: Skeleton;
  readonly roles: readonly (JointRole | null)[];
  readonly sides: readonly (Side | null)[];
  /** (jointCount × 16) `characterFromJoint`, column-major. */
  readonly matrices: Float64Array;
  /** Where each joint is. */
  readonly places: readonly vec3[];
  /** The end of each joint's limb: the next joint of the limb, or the tip that its skin tells. */
  readonly ends: readonly vec3[];
  readonly up: vec3;
  /** Where the body looks to; unit, at a right angle to `up`. Null if nothing tells it. */
  readonly forward: vec3 | null;
}

const known = new WeakMap<Character, Body>();

/** Returns a character's body, which is found when someone first asks. */
export function bodyOf(character: Character): Body {
  let body = known.get(character);
  if (!body) known.set(character, (body = findBody(character)));
  return body;
}

function findBody(character: Character): Body {
  const { skeleton } = character;
  const matrices = jointMatrices(skeleton, zeroPose(skeleton));
  const places = placesOf(matrices);
  const named = namedRoles(skeleton);
  const { roles, sides: found } = shapedRoles(skeleton, places, named);
  const up: vec3 = [0, 1, 0];
  const ends = places.map((_, joint) => endOf(character, roles, matrices, places, joint));
  const across = acrossForward(roles, found, places, up);
  const feet = feetForward(roles, places, ends, up);
  // Sides that no name tells are those of a body that looks along z, until its feet say otherwise.
  const isTurned = found !== named.sides && across && feet && vec3.dot(across, feet) < 0;
  const sides = isTurned ? found.map(otherSide) : found;
  const forward = isTurned ? feet : (across ?? feet);
  return { skeleton, roles, sides, matrices, places, ends, up, forward };
}

/** All degrees of freedom at zero, whether the limits allow it or not. */
function zeroPose({ qRest, dofKind, dofQ }: Skeleton): Float64Array {
  const q = new Float64Array(qRest.length);
  dofKind.forEach((kind, dof) => {
    if ((kind as DofKind) === DofKind.ball) q[dofQ[dof]! + 3] = 1;
  });
  return q;
}

function placesOf(matrices: Float64Array): vec3[] {
  return Array.from({ length: matrices.length / 16 }, (_, joint): vec3 => [
    matrices[joint * 16 + 12]!,
    matrices[joint * 16 + 13]!,
    matrices[joint * 16 + 14]!,
  ]);
}

/** The joint at the end of a limb is the nearest one below it that has one of these roles. */
const nextRoles: Partial<Record<JointRole, readonly JointRole[]>> = {
  clavicle: ['shoulder'],
  shoulder: ['elbow'],
  elbow: ['wrist'],
  wrist: ['finger'],
  hip: ['knee'],
  knee: ['ankle'],
  ankle: ['toe'],
  spine: ['spine', 'neck', 'head', 'pelvis'],
  neck: ['neck', 'head'],
};

function endOf(
  character: Character,
  roles: readonly (JointRole | null)[],
  matrices: Float64Array,
  places: readonly vec3[],
  joint: number,
): vec3 {
  const { depths, jointCount } = character.skeleton;
  const next = nextRoles[roles[joint] ?? 'root'] ?? [];
  for (let at = joint + 1; at < jointCount && depths[at]! > depths[joint]!; at++) {
    const role = roles[at];
    const isApart = vec3.distance(places[at]!, places[joint]!) > 1e-8;
    if (role && next.includes(role) && isApart) return places[at]!;
  }
  const bones = bonesOf(character).filter((bone) => bone.joint === joint);
  const [longest] = bones.sort((a, b) => Math.hypot(...b.vector) - Math.hypot(...a.vector));
  return vec3.transformMat4(
    new Float64Array(3),
    longest?.vector ?? [0, 0, 0],
    matrices.subarray(joint * 16, joint * 16 + 16),
  );
}

/** Where a body looks to by its sides: a quarter turn from its right to its left. */
function acrossForward(
  roles: readonly (JointRole | null)[],
  sides: readonly (Side | null)[],
  places: readonly vec3[],
  up: vec3,
): vec3 | null {
  const across = new Float64Array(3);
  for (const role of ['shoulder', 'elbow', 'hip', 'knee', 'ankle'] as const) {
    const [left, right] = (['left', 'right'] as const).map((side) =>
      places.filter((_, joint) => roles[joint] === role && sides[joint] === side),
    );
    // A pair counts if both are there once, so that uneven sides tell nothing false.
    if (left!.length !== 1 || right!.length !== 1) continue;
    vec3.add(across, across, vec3.subtract(new Float64Array(3), left![0]!, right![0]!));
  }
  return level(vec3.cross(across, across, up), up);
}

/** Where a body's feet point to. */
function feetForward(
  roles: readonly (JointRole | null)[],
  places: readonly vec3[],
  ends: readonly vec3[],
  up: vec3,
): vec3 | null {
  const feet = new Float64Array(3);
  roles.forEach((role, joint) => {
    if (role !== 'ankle') return;
    vec3.add(feet, feet, vec3.subtract(new Float64Array(3), ends[joint]!, places[joint]!));
  });
  return level(feet, up);
}

function otherSide(side: Side | null): Side | null {
  return side && (side === 'left' ? 'right' : 'left');
}

/** The horizontal part of a vector as a unit vector; null if it has none. */
function level(vector: vec3, up: vec3): vec3 | null {
  const flat = vec3.scaleAndAdd(new Float64Array(3), vector, up, -vec3.dot(vector, up));
  return vec3.length(flat) < 1e-9 ? null : vec3.normalize(flat, flat);
}
