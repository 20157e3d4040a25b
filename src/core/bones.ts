import { quat, vec3 } from 'gl-matrix';
import type { Character } from './character.ts';
import type { Mesh } from './mesh.ts';
import { noParent, type Skeleton } from './skeleton.ts';
import { noJoint, type Skin } from './skin.ts';

/**
 * A bone starts at the joint that rotates it. It ends at a child joint or, if the joint has no
 * child, at a derived tip, so that forearms, head and feet have a bone too.
 */
export interface Bone {
  readonly joint: number;
  /** The child joint at its end, or -1 if the end is a derived tip. */
  readonly child: number;
  /** From the joint to the bone's end, in the joint's frame at rest, in model units. */
  readonly vector: readonly [number, number, number];
}

/**
 * A shorter link has no direction; files put several joints at one point (all the MIT models do).
 */
const shortest = 1e-8;

const known = new WeakMap<Character, readonly Bone[]>();

/** Returns the bones of a character; they are derived when someone first asks. */
export function bonesOf(character: Character): readonly Bone[] {
  let bones = known.get(character);
  if (!bones) {
    bones = deriveBones(character.skeleton, character.skin, character.mesh);
    known.set(character, bones);
  }
  return bones;
}

/** Returns all bones that have a length, in the order of their joints. */
function deriveBones(skeleton: Skeleton, skin: Skin, mesh: Mesh): Bone[] {
  const bones: Bone[] = [];
  const isLeaf = new Array<boolean>(skeleton.jointCount).fill(true);
  skeleton.parents.forEach((parent, child) => {
    if (parent === noParent) return;
    isLeaf[parent] = false;
    addBone(parent, child, offsetOf(skeleton, child));
  });
  const tips = skinTips(skin, mesh, isLeaf);
  isLeaf.forEach((leaf, joint) => {
    if (leaf) addBone(joint, -1, tips[joint] ?? extendedTip(skeleton, joint));
  });
  return bones.sort((a, b) => a.joint - b.joint);

  function addBone(joint: number, child: number, vector: vec3): void {
    const [x, y, z] = [vector[0], vector[1], vector[2]];
    if (Math.hypot(x, y, z) > shortest) bones.push({ joint, child, vector: [x, y, z] });
  }
}

function offsetOf(skeleton: Skeleton, joint: number): vec3 {
  return skeleton.restOffsets.slice(joint * 3, joint * 3 + 3);
}

/** Without a skin, a leaf's bone has 0.6 of its parent's length and the parent's direction. */
function extendedTip(skeleton: Skeleton, joint: number): vec3 {
  if (skeleton.parents[joint] === noParent) return [0, 0, 0];
  const offset = offsetOf(skeleton, joint);
  const jointFromParent = skeleton.restRotations.slice(joint * 4, joint * 4 + 4);
  quat.conjugate(jointFromParent, jointFromParent);
  vec3.transformQuat(offset, offset, jointFromParent);
  return vec3.scale(offset, offset, 0.6);
}

/**
 * Derives the tips of leaf joints from the skin. A tip is in the direction of the centroid of the
 * points that mostly follow the joint (weight over one half), at nine tenths of the distance of the
 * farthest of those points in that direction.
 */
function skinTips(skin: Skin, mesh: Mesh, isLeaf: readonly boolean[]): (vec3 | undefined)[] {
  const followers = followersOfLeaves(skin, mesh, isLeaf);
  return isLeaf.map((_, joint) => {
    const points = followers[joint];
    return points && points.length > 0 ? tipAmong(points) : undefined;
  });

  function tipAmong(points: readonly Follower[]): vec3 | undefined {
    const places = points.map(({ point, entry }) => {
      const position = mesh.positions.slice(point * 3, point * 3 + 3);
      const jointFromBind = skin.jointFromBind.subarray(entry * 16, entry * 16 + 16);
      return vec3.transformMat4(new Float64Array(3), position, jointFromBind);
    });
    const direction = new Float64Array(3);
    for (const place of places) vec3.add(direction, direction, place);
    vec3.scale(direction, direction, 1 / places.length);
    if (vec3.length(direction) < shortest) return undefined;
    vec3.normalize(direction, direction);
    const reach = places.reduce((far, place) => Math.max(far, vec3.dot(place, direction)), 0);
    return vec3.scale(direction, direction, 0.9 * reach);
  }
}

interface Follower {
  readonly point: number;
  readonly entry: number;
}

function followersOfLeaves(skin: Skin, mesh: Mesh, isLeaf: readonly boolean[]): Follower[][] {
  const followers: Follower[][] = isLeaf.map(() => []);
  for (let point = 0; point < mesh.pointCount; point++) {
    for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
      const entry = skin.entries[i]!;
      const joint = skin.paletteJoint[entry]!;
      if (joint === noJoint || !isLeaf[joint] || skin.weights[i]! <= 0.5) continue;
      followers[joint]!.push({ point, entry });
    }
  }
  return followers;
}
