import { mat4, vec3 } from 'gl-matrix';
import { jointMatrices } from './forward-kinematics.ts';
import { noParent, type Skeleton } from './skeleton.ts';

/**
 * A bone as defined by UT CS354's Virtual Mannequin. It goes from a joint to a child of that joint,
 * so each joint except the roots is the end of one bone. The axes t, n, b are those of the rest
 * pose (the file's pose), and t points along the bone. All matrices are 4 × 4, column-major,
 * float64.
 *
 * `T₀ R₀ … Tᵢ` maps the bone's origin to the world. `T₀ R₀ … Tᵢ Rᵢ` maps the bone's own space to
 * the world; the far end is at `(length, 0, 0)` in that space.
 */
export interface BoneFrame {
  /** The joint that the bone starts at; it rotates the bone. */
  readonly source: number;
  /** The joint that the bone ends at. */
  readonly destination: number;
  /** Index among the frames of the bone that ends at `source`, or -1. */
  readonly parent: number;
  /** In model units. */
  readonly length: number;
  /**
   * T: translates along the parent's t by the parent's length; without a parent, to the source in
   * the world.
   */
  readonly translation: mat4;
  /** R: maps the bone's axes to its parent's; without a parent, to the world's. */
  readonly rotation: mat4;
  /** t, n and b in the world, as its first three columns. */
  readonly axes: mat4;
  /** t, n and b in the frame of the source joint. */
  readonly sourceAxes: mat4;
}

/** A shorter link has no direction; some files have several joints at one point. */
const shortest = 1e-8;

/** Returns all bones, in the file's order of the joints that they end at. */
export function boneFrames(skeleton: Skeleton): BoneFrame[] {
  const world = jointMatrices(skeleton, skeleton.qRest);
  const destinations = [...skeleton.jointOfSource].filter(
    (joint) => skeleton.parents[joint] !== noParent,
  );
  const boneAt = new Map(destinations.map((joint, index) => [joint, index]));
  const frames = new Array<BoneFrame>(destinations.length);
  // A parent joint comes before its children, so the bone that ends at it already exists.
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const index = boneAt.get(joint);
    if (index !== undefined) frames[index] = frameTo(joint);
  }
  return frames;

  function frameTo(destination: number): BoneFrame {
    const source = skeleton.parents[destination]!;
    const parent = boneAt.get(source) ?? -1;
    const above = frames[parent];
    const [from, to] = [placeOf(world, source), placeOf(world, destination)];
    const along = vec3.subtract(new Float64Array(3), to, from);
    const length = vec3.length(along);
    const axes = length < shortest ? (above?.axes ?? identity()) : tangentAxes(along);
    return {
      source,
      destination,
      parent,
      length,
      translation: translated(above ? [above.length, 0, 0] : from),
      rotation: above ? between(above.axes, axes) : axes,
      axes,
      sourceAxes: between(turnOf(world, source), axes),
    };
  }
}

/**
 * Returns the axes of a bone by the handout's construction: e is the unit vector along the smallest
 * component of the direction t (the first one if several are equal), n = t × e, normalized,
 * and b = t × n.
 *
 * @param along the direction, of any length except 0
 */
export function tangentAxes(along: vec3): mat4 {
  const t = vec3.normalize(new Float64Array(3), along);
  const sizes = [Math.abs(t[0]), Math.abs(t[1]), Math.abs(t[2])];
  const e = new Float64Array(3);
  e[sizes.indexOf(Math.min(...sizes))] = 1;
  const n = vec3.cross(new Float64Array(3), t, e);
  vec3.normalize(n, n);
  const b = vec3.cross(new Float64Array(3), t, n);
  const axes = identity();
  axes.set(t, 0);
  axes.set(n, 4);
  axes.set(b, 8);
  return axes;
}

/**
 * Returns S of a bone, which is R in a pose. The joint that a bone starts at rotates the bone's
 * axes, so all bones of one joint rotate together.
 *
 * @param characterFromJoint (jointCount × 16) of the pose
 */
export function posedRotation(
  frames: readonly BoneFrame[],
  bone: number,
  characterFromJoint: Float64Array,
): mat4 {
  const axes = posedAxes(frames[bone]!, characterFromJoint);
  const above = frames[frames[bone]!.parent];
  return above ? between(posedAxes(above, characterFromJoint), axes) : axes;
}

function posedAxes({ source, sourceAxes }: BoneFrame, characterFromJoint: Float64Array): mat4 {
  const turn = turnOf(characterFromJoint, source);
  return mat4.multiply(turn, turn, sourceAxes);
}

/** A bone as placed by its chain of transforms. */
export interface PlacedBone {
  readonly origin: vec3;
  readonly end: vec3;
  /** t, n and b in its first three columns. */
  readonly axes: mat4;
}

/**
 * Computes T₀ S₀ … Tᵢ Sᵢ of every bone. With R for S this is the rest pose; changing one S moves
 * all bones below it.
 */
export function placeBones(
  frames: readonly BoneFrame[],
  rotations: readonly mat4[] = frames.map(({ rotation }) => rotation),
): PlacedBone[] {
  const placed = new Array<mat4 | undefined>(frames.length);
  return frames.map(({ length }, bone) => {
    const matrix = place(bone);
    const end: vec3 = vec3.transformMat4(new Float64Array(3), [length, 0, 0], matrix);
    return { origin: placeOf(matrix, 0), end, axes: turnOf(matrix, 0) };
  });

  /** From the bone's space to the world. Recursive, because a parent may come after its child. */
  function place(bone: number): mat4 {
    const pending: number[] = [];
    for (let at = bone; at !== -1 && !placed[at]; at = frames[at]!.parent) pending.push(at);
    for (const at of pending.reverse()) {
      const { parent, translation } = frames[at]!;
      const matrix = identity();
      if (parent !== -1) matrix.set(placed[parent]!);
      mat4.multiply(matrix, matrix, translation);
      placed[at] = mat4.multiply(matrix, matrix, rotations[at]!);
    }
    return placed[bone]!;
  }
}

/** The rotation from the second axes to the first, F₁ᵀ · F₂ (both are rotations). */
function between(first: mat4, second: mat4): Float64Array {
  const inverse = Float64Array.from(first, (_, i) => first[(i % 4) * 4 + (i >> 2)]!);
  return mat4.multiply(identity(), inverse, second) as Float64Array;
}

function placeOf(matrices: ArrayLike<number>, index: number): vec3 {
  return Float64Array.from([12, 13, 14], (i) => matrices[index * 16 + i]!);
}

/** The rotation part of a matrix, without its translation. */
function turnOf(matrices: ArrayLike<number>, index: number): mat4 {
  const turn = identity();
  for (let i = 0; i < 12; i++) turn[i] = matrices[index * 16 + i]!;
  return turn;
}

function translated(offset: vec3): Float64Array {
  const matrix = identity();
  matrix.set(offset, 12);
  return matrix;
}

function identity(): Float64Array {
  return mat4.identity(new Float64Array(16)) as Float64Array;
}
