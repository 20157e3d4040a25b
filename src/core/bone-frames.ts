import { mat4, vec3 } from 'gl-matrix';
import { jointMatrices } from './forward-kinematics.ts';
import { noParent, type Skeleton } from './skeleton.ts';

/**
 * A bone as UT CS354's Virtual Mannequin has it: from a joint to a child of it, one for each pair, so
 * that each joint but the roots has one bone that ends at it. Its axes t, n, b are those of the rest
 * (the file's pose); t runs along it. All matrices 4 × 4, column-major, float64.
 *
 * `T₀ R₀ … Tᵢ` maps the bone's origin to the world, `T₀ R₀ … Tᵢ Rᵢ` its own space: its far end is
 * `(length, 0, 0)` there.
 */
export interface BoneFrame {
  /** The joint that it starts at, which turns it. */
  readonly source: number;
  /** The joint that it ends at. */
  readonly destination: number;
  /** The bone that ends at its source, or -1: index among the frames. */
  readonly parent: number;
  /** Model units. */
  readonly length: number;
  /** T: along the parent's t by the parent's length; without parent to the source, in the world. */
  readonly translation: mat4;
  /** R: from the bone's axes to its parent's; without parent to the world's. */
  readonly rotation: mat4;
  /** t, n and b in the world, as its first three columns. */
  readonly axes: mat4;
  /** The same in the frame of the source, which carries them along. */
  readonly sourceAxes: mat4;
}

/** A link that is shorter has no direction: files put joints on one point. */
const shortest = 1e-8;

/** All bones, in the file's order of the joints that they end at. */
export function boneFrames(skeleton: Skeleton): BoneFrame[] {
  const world = jointMatrices(skeleton, skeleton.qRest);
  const destinations = [...skeleton.jointOfSource].filter(
    (joint) => skeleton.parents[joint] !== noParent,
  );
  const boneAt = new Map(destinations.map((joint, index) => [joint, index]));
  const frames = new Array<BoneFrame>(destinations.length);
  // A joint's parent stands before it, and so the bone that ends there is made first.
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
      translation: mat4.fromTranslation(identity(), above ? [above.length, 0, 0] : from),
      rotation: above ? between(above.axes, axes) : axes,
      axes,
      sourceAxes: between(turnOf(world, source), axes),
    };
  }
}

/**
 * The axes of a bone by the handout's trick: e is the unit vector of the direction's smallest component
 * (the first of equals), n = t × e made unit, b = t × n.
 *
 * @param along the direction, of any length but 0
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
 * S of a bone, which is R in a pose: the joint that a bone starts at carries its axes along, so that all
 * bones of one joint turn together.
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

/** A bone where its chain puts it. */
export interface PlacedBone {
  readonly origin: vec3;
  readonly end: vec3;
  /** t, n and b as its first three columns. */
  readonly axes: mat4;
}

/** T₀ S₀ … Tᵢ Sᵢ of every bone: with R for S the rest, and with one changed all that hangs on it moves. */
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

  /** From the bone's space to the world; along the chain, since a parent may stand after its child. */
  function place(bone: number): mat4 {
    const pending: number[] = [];
    for (let at = bone; at !== -1 && !placed[at]; at = frames[at]!.parent) pending.push(at);
    for (const at of pending.reverse()) {
      const { parent, translation } = frames[at]!;
      const matrix = identity();
      if (parent !== -1) mat4.copy(matrix, placed[parent]!);
      mat4.multiply(matrix, matrix, translation);
      placed[at] = mat4.multiply(matrix, matrix, rotations[at]!);
    }
    return placed[bone]!;
  }
}

/** From the second axes to the first, F₁ᵀ · F₂: both are rotations. */
function between(first: mat4, second: mat4): Float64Array {
  const inverse = mat4.transpose(identity(), first);
  return mat4.multiply(identity(), inverse, second) as Float64Array;
}

function placeOf(matrices: ArrayLike<number>, index: number): vec3 {
  return Float64Array.from([12, 13, 14], (i) => matrices[index * 16 + i]!);
}

/** The rotation of a matrix without its translation. */
function turnOf(matrices: ArrayLike<number>, index: number): mat4 {
  const turn = identity();
  for (let i = 0; i < 12; i++) turn[i] = matrices[index * 16 + i]!;
  return turn;
}

function identity(): Float64Array {
  return mat4.identity(new Float64Array(16)) as Float64Array;
}
