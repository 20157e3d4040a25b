import { mat4 } from 'gl-matrix';
import { buildCharacter } from '../core/build-character.ts';
import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import { jointMatrices } from '../core/forward-kinematics.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import type { Pose } from '../core/pose.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import { firstRoot } from '../core/subtree.ts';
import { noJoint } from '../core/skin.ts';
import { ballValue, quaternionOf } from './ball-values.ts';
import { convertClip, type ConvertedClip } from './convert-clip.ts';
import { partsLost } from './convert-losses.ts';
import { convertParts, tripleAt } from './convert-parts.ts';
import { bindMatrix } from './cse169/write-skin.ts';
import { fitsShape } from './fits-shape.ts';
import { clipDepthFirst, numberedDepthFirst } from './nested-order.ts';
import { type ConvertTarget, shapeOf } from './registry.ts';
import { solvePose, type Target } from './solve-pose.ts';
import { lost } from './lost.ts';

export interface Converted {
  readonly character: Character;
  /** The pose that looks the same as the given one, in the angles of the other format. */
  readonly pose: Pose;
  readonly losses: readonly Diagnostic[];
  /** Converts a clip of the character; equal angles are different rotations in the two formats. */
  readonly convertClip: (clip: ClipParts) => ConvertedClip;
}

/**
 * Converts a character to what the files of another format can hold, together with the pose that
 * looks the same. It preserves rotations, not numbers: equal angles are different rotations in the
 * two formats, so the angles are solved again. A character that already has the format's shape is
 * returned unchanged.
 *
 * If the format has its own bindings (CSE169), the frames of the joints stay, and the rest of the
 * source file becomes the pose of the new file. Otherwise (6.837, PMD) every joint is bound without
 * rotation where the mesh is: frames are taken from the binding, and the rotation of the joints
 * since then is the pose.
 */
export function convertCharacter(character: Character, to: ConvertTarget, pose: Pose): Converted {
  const { skeleton, skin, name } = character;
  const losses: Diagnostic[] = [];
  const shape = shapeOf(to);
  if (skeleton.jointCount === 0 || fitsShape(character, shape)) {
    return { character, pose, losses, convertClip: (clip) => ({ clip, losses: [] }) };
  }
  const insertRoot = !shape.firstJointWeights && firstJointHasWeight(character);
  const bound = bindPlaces(character);
  const target: Target = {
    product: shape.turns === 'ball' ? 'xyz' : shape.turns,
    turnsByBall: shape.turns === 'ball',
    frames: shape.bindings ? 'joint' : 'bind',
    insertRoot,
    bound,
  };
  const rest = shape.restPose ? solvePose(skeleton, skin, skeleton.qRest, target) : null;
  const parts = convertParts(character, shape, target, rest?.angles ?? null);
  const built = buildCharacter(parts).value!;
  const solved = solvePose(skeleton, skin, pose.q, target);
  const q = poseOf(built.skeleton, skeleton, solved, insertRoot);
  const error = residual(character, pose, built, q, insertRoot);
  if (error > 1e-5) {
    const found = `matrices that are off by up to ${Number(error.toPrecision(2))}`;
    const effect = 'the pose is as near as the format can hold it';
    losses.push(
      lost(name, 'joints that only turn, bound where the skeleton has them', found, effect),
    );
  }
  if (insertRoot) {
    const effect = 'a root without weight is put before it, and the other joints count one up';
    losses.push(
      lost(name, 'a first joint without weights', skeleton.names[first(skeleton)]!, effect),
    );
  }
  losses.push(...partsLost(character, shape));
  const conversion = { from: character, to: built, target, q: pose.q };
  return {
    character: shape.nests ? numberedDepthFirst(built) : built,
    pose: { q },
    losses,
    convertClip(clip) {
      const made = convertClip(clip, conversion);
      if (!shape.nests) return made;
      return { ...made, clip: clipDepthFirst(made.clip, built.skeleton) };
    },
  };
}

function first(skeleton: Skeleton): number {
  return skeleton.jointOfSource[0]!;
}

function firstJointHasWeight({ skeleton, skin }: Character): boolean {
  const joint = first(skeleton);
  return skin.entries.some((entry, i) => {
    return skin.paletteJoint[entry] === joint && skin.weights[i] !== 0;
  });
}

/** (jointCount × 3) positions of the joints at bind time; at rest, if the mesh has no weights. */
function bindPlaces({ skeleton, skin }: Character): Float64Array {
  const world = jointMatrices(skeleton, skeleton.qRest);
  const places = new Float64Array(skeleton.jointCount * 3);
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const entry = skin.paletteJoint.indexOf(joint);
    const matrix = entry === -1 ? world.subarray(joint * 16) : bindMatrix(skin, entry);
    places.set(matrix.subarray(12, 15), joint * 3);
  }
  return places;
}

/** Converts the solved angles and the root's displacement to values of the new skeleton. */
function poseOf(
  built: Skeleton,
  skeleton: Skeleton,
  solved: { readonly angles: Float64Array; readonly root: readonly number[] },
  insertRoot: boolean,
): Float64Array {
  const q = built.qRest.slice();
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const target = built.jointOfSource[skeleton.sourceIndex[joint]! + Number(insertRoot)]!;
    const angles = tripleAt(solved.angles, joint);
    const ball = ballValue(built, target);
    if (ball >= 0) q.set(quaternionOf(angles), ball);
    else setValues(target, DofKind.hinge, angles);
  }
  setValues(firstRoot(built), DofKind.slide, solved.root);
  return q;

  function setValues(joint: number, kind: number, values: readonly number[]): void {
    for (let dof = built.dofStart[joint]!; dof < built.dofStart[joint + 1]!; dof++) {
      if (built.dofKind[dof] !== kind) continue;
      const axis = [0, 1, 2].find((i) => built.dofAxis[dof * 3 + i] === 1)!;
      q[built.dofQ[dof]!] = values[axis]!;
    }
  }
}

/**
 * The largest difference between the skinning matrices of both characters, relative to their size.
 */
function residual(
  old: Character,
  pose: Pose,
  built: Character,
  q: Float64Array,
  insertRoot: boolean,
): number {
  if (old.skin.paletteJoint.includes(noJoint)) return 0;
  const [a, b] = [jointMatrices(old.skeleton, pose.q), jointMatrices(built.skeleton, q)];
  const [first, second] = [new Float64Array(16), new Float64Array(16)];
  let largest = 0;
  old.skin.paletteJoint.forEach((joint, entry) => {
    const target =
      built.skeleton.jointOfSource[old.skeleton.sourceIndex[joint]! + Number(insertRoot)]!;
    const product = (
      out: Float64Array,
      world: Float64Array,
      at: number,
      bind: Float64Array,
      e: number,
    ) =>
      mat4.multiply(out, world.subarray(at * 16, at * 16 + 16), bind.subarray(e * 16, e * 16 + 16));
    product(first, a, joint, old.skin.jointFromBind, entry);
    product(second, b, target, built.skin.jointFromBind, target);
    first.forEach((value, i) => (largest = Math.max(largest, Math.abs(value - second[i]!))));
  });
  return largest;
}
