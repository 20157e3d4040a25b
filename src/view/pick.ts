import { vec3 } from 'gl-matrix';
import type { Bone } from '../core/bones.ts';
import { distanceToSegment, pointOnRay, type Ray } from '../core/ray.ts';
import type { Session } from '../document/session.ts';
import type { Evaluations } from '../evaluation/evaluations.ts';
import { pickSkin } from '../posing/pick-skin.ts';
import { displayTransform } from './display-transform.ts';
import { pickBox } from './pick-box.ts';
import { characterRay, pickJoint, type PickTarget, rayThrough, sizeOfPixel } from './picking.ts';
import type { Viewer } from './viewer.ts';

/** A place in the view, and how near to it is near enough. */
export interface PickPlace {
  /** From -1 (left) to 1. */
  readonly x: number;
  /** From -1 (bottom) to 1. */
  readonly y: number;
  /** CSS pixels of a view `viewHeight` tall. */
  readonly tolerance: number;
  readonly viewHeight: number;
}

/** What is under a place of the view. */
export interface BoneTarget {
  readonly joint: number;
  /** Of the bones that start at the joint, the one that was met, or is nearest to it; or none. */
  readonly bone: Bone | null;
  /** The place itself, character space. */
  readonly grabbed: readonly [number, number, number];
  /** From the eye, in the character's units. */
  readonly distance: number;
}

/** Where it is picked: what the interface and the tools have at hand. */
interface Scene {
  readonly evaluations: Evaluations;
  readonly session: Session;
  readonly viewer: Viewer;
}

/** The ray of sight through a place of the view, in the selected character's space. */
export function characterRayAt({ evaluations, viewer }: Scene, { x, y }: PickPlace): Ray {
  const ray = rayThrough(viewer.camera.value, viewer.aspect, x, y);
  const shown = evaluations.selected();
  return shown ? characterRay(displayTransform(shown.state.character), ray) : ray;
}

/**
 * The joint of the selected character at a place of the view: of its bones or boxes where they are shown,
 * and where the skin hides them, the one that owns the skin there.
 */
export function boneAt(scene: Scene, place: PickPlace): BoneTarget | null {
  const { evaluations, session, viewer } = scene;
  const shown = evaluations.selected();
  if (!shown) return null;
  const { characterFromJoint, skin } = shown;
  const { character } = shown.state;
  const display = displayTransform(character);
  const target = { character, display, characterFromJoint };
  const ray = characterRayAt(scene, place);
  if (session.showSkin.value && !session.translucent.value) {
    const hit = pickSkin(character.mesh, skin, shown.vertices().positions, ray);
    if (hit) return hit.joint === null ? null : atJoint(target, hit.joint, ray, hit.distance);
  }
  if (!session.showSkeleton.value) return null;
  const camera = viewer.camera.value;
  const style = session.skeletonStyle.value;
  if (style === 'boxes' || style === 'both') {
    const box = pickBox(target, ray);
    if (box) return atJoint(target, box.joint, ray, box.distance);
    if (style === 'boxes' && character.skeleton.displayBoxes) return null;
  }
  const sceneRay = rayThrough(camera, viewer.aspect, place.x, place.y);
  const pixel = sizeOfPixel(camera, place.viewHeight);
  const hit = pickJoint(target, sceneRay, place.tolerance * pixel);
  if (!hit) return null;
  const found = atJoint(target, hit.joint, ray, hit.distance);
  return hit.bone ? { ...found, bone: hit.bone } : found;
}

function atJoint(
  { character, characterFromJoint }: PickTarget,
  joint: number,
  ray: Ray,
  distance: number,
): BoneTarget {
  const [x, y, z] = pointOnRay(ray, distance) as [number, number, number];
  const matrix = characterFromJoint.subarray(joint * 16, joint * 16 + 16);
  const own = character.bones.filter((bone) => bone.joint === joint);
  const gaps = own.map(({ vector }) => {
    const start = vec3.transformMat4(new Float64Array(3), [0, 0, 0], matrix);
    const end = vec3.transformMat4(new Float64Array(3), vector, matrix);
    return distanceToSegment([x, y, z], start, end);
  });
  const bone = own[gaps.indexOf(Math.min(...gaps))] ?? null;
  return { joint, bone, grabbed: [x, y, z], distance };
}
