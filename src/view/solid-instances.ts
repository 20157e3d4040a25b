import { mat4, type ReadonlyVec3 } from 'gl-matrix';
import { tangentAxes } from '../core/bone-frames.ts';
import { type Bone, bonesOf } from '../core/bones.ts';
import type { CharacterView } from './character-view.ts';
import { jointColorsOf } from '../skinning/weights/joint-colors.ts';
import { showsWeights, type ViewOptions } from './view-options.ts';
import { instanceSize } from './instanced-solid.ts';
import { boneRadius, boneReach, jointRadius } from './solid-sizes.ts';
import { linearChannel, palette } from './theme.ts';

/** Lengths are in scene units. */
const originAxisLength = 0.3;
const jointAxisLength = 0.07;
const axisThickness = 0.06; // as a fraction of the length

type Color = readonly number[];

/** The joints that are highlighted. */
export interface JointMarks {
  readonly selected: readonly number[];
  /** Those that mirror the selected ones, in a fainter color. */
  readonly mirrored: readonly number[];
  readonly hovered: number | null;
  /** (jointCount × 3) the bytes of the joints' own colors where weights are shown, or null. */
  readonly colors: Uint8Array | null;
}

/** Returns the marks of a view. */
export function marksOf({ state }: CharacterView, options: ViewOptions): JointMarks {
  const { selectedActorId, selectedJoints, mirroredJoints, hoveredLimb } = options;
  return {
    selected: state.id === selectedActorId ? selectedJoints : [],
    mirrored: state.id === selectedActorId ? mirroredJoints : [],
    hovered: state.id === hoveredLimb?.actorId ? hoveredLimb.joint : null,
    colors: showsWeights(state.id, options) ? jointColorsOf(state.character.skeleton).bytes : null,
  };
}

/**
 * Returns a key for the poses and places of views and for their highlighted joints. While it is the
 * same, so are the instances.
 */
export function keyOf(views: readonly CharacterView[], options?: ViewOptions): string {
  const keys = views.map((view) => {
    const { pose, display } = view.evaluation.revisions;
    const { selected, mirrored, hovered, colors } = options ? marksOf(view, options) : noMarks;
    const marked = `${selected.join()} ${mirrored.join()} ${hovered}`;
    return `${pose} ${display} ${marked} ${colors !== null}`;
  });
  return keys.join();
}

/** The gray to which colors are dimmed, in linear light. */
const dimmedLight = 0.2;

export const noMarks: JointMarks = { selected: [], mirrored: [], hovered: null, colors: null };

function colorOf(joint: number, marks: JointMarks, plain: Color): Color {
  const { selected, mirrored, hovered, colors } = marks;
  if (colors) {
    const own = [0, 1, 2].map((i) => linearChannel(colors[joint * 3 + i]! / 255));
    const isDimmed = hovered !== null && hovered !== joint;
    return isDimmed ? own.map((channel) => 0.15 * channel + 0.85 * dimmedLight) : own;
  }
  if (selected.includes(joint)) return palette.selected;
  if (joint === hovered) return palette.hovered;
  const isMirrored = mirrored.includes(joint);
  return isMirrored ? plain.map((light, i) => (light + palette.selected[i]!) / 2) : plain;
}

/** Creates a sphere at every joint. */
export function jointInstances(view: CharacterView, marks: JointMarks): Float32Array {
  const { jointCount } = view.state.character.skeleton;
  const instances = new Float32Array(jointCount * instanceSize);
  const radius = jointRadius / view.display.scale;
  const jointFromSphere = placedSolid([0, 0, 0], [radius, radius, radius]);
  for (let joint = 0; joint < jointCount; joint++) {
    writeInstance(
      view,
      joint,
      jointFromSphere,
      colorOf(joint, marks, palette.bone),
      instances,
      joint,
    );
  }
  return instances;
}

/** Creates a cylinder along every bone, in the frame of the joint that turns it. */
export function boneInstances(view: CharacterView, marks: JointMarks): Float32Array {
  return instancesAlong(view, bonesOf(view.state.character), marks, boneRadius, palette.bone);
}

/** Creates a line along every bone. */
export function boneLineInstances(view: CharacterView, marks: JointMarks): Float32Array {
  return instancesAlong(view, bonesOf(view.state.character), marks, boneRadius, palette.boneLine);
}

/** Creates the cylinder around the highlighted bone, with the radius that picking uses. */
export function litBoneInstance(view: CharacterView, bone: Bone): Float32Array {
  return instancesAlong(view, [bone], noMarks, boneReach, palette.litBone);
}

function instancesAlong(
  view: CharacterView,
  bones: readonly Bone[],
  marks: JointMarks,
  radius: number,
  plain: Color,
): Float32Array {
  const instances = new Float32Array(bones.length * instanceSize);
  bones.forEach((bone, index) => {
    const matrix = frameAlong(bone.vector, radius / view.display.scale);
    writeInstance(view, bone.joint, matrix, colorOf(bone.joint, marks, plain), instances, index);
  });
  return instances;
}

/** Creates the handout's t, n and b of every bone at its origin, a quarter of its length. */
export function boneAxisInstances(view: CharacterView): Float32Array {
  const bones = bonesOf(view.state.character);
  const instances = new Float32Array(bones.length * 3 * instanceSize);
  bones.forEach(({ joint, vector }, index) => {
    const axes = tangentAxes([...vector]);
    const length = Math.hypot(...vector) / 4;
    for (let axis = 0; axis < 3; axis++) {
      const along = [0, 1, 2].map((i) => axes[axis * 4 + i]! * length);
      const matrix = frameAlong(along, length * axisThickness);
      writeInstance(view, joint, matrix, palette.axes[axis]!, instances, index * 3 + axis);
    }
  });
  return instances;
}

/**
 * Creates the box of every joint that has one, from its lower to its upper corner in the joint's
 * frame.
 */
export function boxInstances(view: CharacterView, marks: JointMarks): Float32Array {
  const { displayBoxes, jointCount } = view.state.character.skeleton;
  if (!displayBoxes) return new Float32Array(0);
  const instances = new Float32Array(jointCount * instanceSize);
  for (let joint = 0; joint < jointCount; joint++) {
    const box = displayBoxes.subarray(joint * 6, joint * 6 + 6);
    const middle = [0, 1, 2].map((i) => (box[i]! + box[i + 3]!) / 2) as [number, number, number];
    const half = [0, 1, 2].map((i) => (box[i + 3]! - box[i]!) / 2) as [number, number, number];
    const jointFromCube = placedSolid(middle, half);
    writeInstance(
      view,
      joint,
      jointFromCube,
      colorOf(joint, marks, palette.bone),
      instances,
      joint,
    );
  }
  return instances;
}

/** Creates axes at the origin of the file's space and, if requested, small ones at every joint. */
export function axisInstances(view: CharacterView, withJoints: boolean): Float32Array {
  const jointCount = withJoints ? view.state.character.skeleton.jointCount : 0;
  const instances = new Float32Array((jointCount + 1) * 3 * instanceSize);
  for (let joint = -1; joint < jointCount; joint++) {
    const length = (joint < 0 ? originAxisLength : jointAxisLength) / view.display.scale;
    for (let axis = 0; axis < 3; axis++) {
      const vector = [0, 1, 2].map((i) => (i === axis ? length : 0));
      const matrix = frameAlong(vector, (length * axisThickness) / 2);
      writeInstance(view, joint, matrix, palette.axes[axis]!, instances, (joint + 1) * 3 + axis);
    }
  }
  return instances;
}

/** Maps the unit cylinder to one from the origin to `vector`, with a frame that contains no NaN. */
function frameAlong(vector: readonly number[], radius: number): mat4 {
  const length = Math.hypot(...vector);
  const [x, y, z] = vector.map((component) => component / length) as [number, number, number];
  // This is the coordinate axis that is farthest from the direction.
  const size = [Math.abs(x), Math.abs(y), Math.abs(z)];
  const least = size.indexOf(Math.min(...size));
  const [ex, ey, ez] = [0, 1, 2].map((i) => (i === least ? 1 : 0)) as [number, number, number];
  const across = [y * ez - z * ey, z * ex - x * ez, x * ey - y * ex];
  const norm = radius / Math.hypot(...across);
  const [ax, ay, az] = across.map((component) => component * norm) as [number, number, number];
  const [bx, by, bz] = [ay * z - az * y, az * x - ax * z, ax * y - ay * x];
  return [...[ax, ay, az, 0], ...vector, 0, ...[bx, by, bz, 0], ...[0, 0, 0, 1]] as mat4;
}

/** @param joint -1 for the character's own space */
function writeInstance(
  view: CharacterView,
  joint: number,
  jointFromSolid: mat4,
  color: Color,
  instances: Float32Array,
  index: number,
): void {
  sceneFromSolid.set(view.display.sceneFromCharacter);
  if (joint >= 0) {
    const characterFromJoint = view.characterFromJoint.subarray(joint * 16, joint * 16 + 16);
    mat4.multiply(sceneFromSolid, sceneFromSolid, characterFromJoint);
  }
  mat4.multiply(sceneFromSolid, sceneFromSolid, jointFromSolid);
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 4; column++) {
      instances[index * instanceSize + row * 4 + column] = sceneFromSolid[column * 4 + row]!;
    }
  }
  instances.set(color, index * instanceSize + 12);
}

const sceneFromSolid = new Float64Array(16);

/** Returns the matrix that moves the unit solid to a place and gives it half its size on each axis. */
function placedSolid(middle: ReadonlyVec3, half: ReadonlyVec3): mat4 {
  const matrix: mat4 = new Float64Array(16);
  mat4.fromRotationTranslation(matrix, [0, 0, 0, 1], middle);
  return mat4.scale(matrix, matrix, half);
}
