import { vec3 } from 'gl-matrix';
import { type Bone, bonesOf } from '../core/bones.ts';
import { distanceToSegment, pointOnRay, type Ray } from '../core/ray.ts';
import type { ActorId } from '../document/scene.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import type { Evaluations, Overrides } from '../evaluation/evaluations.ts';
import { pickSkin } from '../posing/pick-skin.ts';
import { pickBox } from './pick-box.ts';
import { characterRay, pickJoint, rayThrough, sizeOfPixel } from './picking.ts';
import { posedTriangles } from './posed-triangles.ts';
import type { Viewer } from './viewer.ts';

/** A place in the view, with the distance that still counts as a hit. */
export interface PickPlace {
  /** From -1 (left) to 1. */
  readonly x: number;
  /** From -1 (bottom) to 1. */
  readonly y: number;
  /** The tolerance in CSS pixels of a view that is `viewHeight` tall. */
  readonly tolerance: number;
  readonly viewHeight: number;
  /** What differs from the scene in the view that has the place, as a method does. */
  readonly overrides?: Overrides;
}

/** What lies at a place of the view. */
export interface BoneTarget {
  readonly actorId: ActorId;
  readonly joint: number;
  /**
   * The bone that was hit, or else the nearest of those that start at the joint; null if there is
   * none.
   */
  readonly bone: Bone | null;
  /** The place itself, in character space. */
  readonly grabbed: readonly [number, number, number];
  /** The distance from the eye, in the character's units. */
  readonly distance: number;
}

/** What picking needs, which the interface and the tools provide. */
export interface Looking {
  readonly store: Store;
  readonly evaluations: Evaluations;
  readonly session: Session;
  readonly viewer: Viewer;
}

/** Returns the view ray through a place of the view, in the selected character's space. */
export function characterRayAt({ evaluations, viewer }: Looking, { x, y }: PickPlace): Ray {
  const ray = rayThrough(viewer.viewCamera.value, viewer.aspect, x, y);
  const shown = evaluations.selected();
  return shown ? characterRay(shown.display, ray) : ray;
}

/**
 * Returns the joint at a place of the view, for the nearest actor there. It is found by the bones
 * or boxes where they are shown; where the skin hides them, it is the joint that owns the skin
 * there.
 */
export function boneAt(look: Looking, place: PickPlace): BoneTarget | null {
  let nearest: Hit | null = null;
  for (const evaluation of look.evaluations.visible(place.overrides)) {
    const hit = hitOf(evaluation, look, place);
    if (hit && hit.sceneDistance < (nearest?.sceneDistance ?? Infinity)) nearest = hit;
  }
  return nearest?.target ?? null;
}

/**
 * What a place hits of an actor. Skin that no joint owns is hit too, and hides what is behind it.
 */
interface Hit {
  readonly sceneDistance: number;
  readonly target: BoneTarget | null;
}

function hitOf(shown: Evaluation, look: Looking, place: PickPlace): Hit | null {
  const { session, viewer } = look;
  const { characterFromJoint, skin, display, state } = shown;
  const { character } = state;
  const camera = viewer.viewCamera.value;
  const sceneRay = rayThrough(camera, viewer.aspect, place.x, place.y);
  const ray = characterRay(display, sceneRay);
  const at = (joint: number | null, distance: number, bone?: Bone | null): Hit => ({
    sceneDistance: distance * display.scale,
    target: joint === null ? null : atJoint(shown, joint, ray, distance, bone),
  });
  if (session.showSkin.value && !session.translucent.value) {
    const hit = pickSkin(character.mesh, skin, posedTriangles(shown), ray);
    if (hit) return at(hit.joint, hit.distance);
  }
  if (!session.showSkeleton.value) return null;
  const target = { character, display, characterFromJoint };
  const style = session.skeletonStyle.value;
  if (style === 'boxes' || style === 'both') {
    const box = pickBox(target, ray);
    if (box) return at(box.joint, box.distance);
    if (style === 'boxes' && character.skeleton.displayBoxes) return null;
  }
  const pixel = sizeOfPixel(camera, place.viewHeight);
  const hit = pickJoint(target, sceneRay, place.tolerance * pixel);
  return hit && at(hit.joint, hit.distance, hit.bone);
}

/**
 * @param met the bone that was hit; without one, the nearest of the bones that start at the joint
 *   is used
 */
function atJoint(
  { state: { id, character }, characterFromJoint }: Evaluation,
  joint: number,
  ray: Ray,
  distance: number,
  met?: Bone | null,
): BoneTarget {
  const [x, y, z] = pointOnRay(ray, distance) as [number, number, number];
  const matrix = characterFromJoint.subarray(joint * 16, joint * 16 + 16);
  const own = bonesOf(character).filter((bone) => bone.joint === joint);
  const gaps = own.map(({ vector }) => {
    const start = vec3.transformMat4(new Float64Array(3), [0, 0, 0], matrix);
    const end = vec3.transformMat4(new Float64Array(3), vector, matrix);
    return distanceToSegment([x, y, z], start, end);
  });
  const bone = met ?? own[gaps.indexOf(Math.min(...gaps))] ?? null;
  return { actorId: id, joint, bone, grabbed: [x, y, z], distance };
}
