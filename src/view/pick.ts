import { vec3 } from 'gl-matrix';
import type { Bone } from '../core/bones.ts';
import { distanceToSegment, pointOnRay, type Ray } from '../core/ray.ts';
import type { ActorId } from '../document/scene.ts';
import type { Session } from '../document/session.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import type { Evaluations } from '../evaluation/evaluations.ts';
import { pickSkin } from '../posing/pick-skin.ts';
import { pickBox } from './pick-box.ts';
import { characterRay, pickJoint, rayThrough, sizeOfPixel } from './picking.ts';
import { posedTriangles } from './posed-triangles.ts';
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
  readonly actorId: ActorId;
  readonly joint: number;
  /** Of the bones that start at the joint, the one that was met, or is nearest to it; or none. */
  readonly bone: Bone | null;
  /** The place itself, character space. */
  readonly grabbed: readonly [number, number, number];
  /** From the eye, in the character's units. */
  readonly distance: number;
}

/** Where it is picked: what the interface and the tools have at hand. */
interface Looking {
  readonly evaluations: Evaluations;
  readonly session: Session;
  readonly viewer: Viewer;
}

/** The ray of sight through a place of the view, in the selected character's space. */
export function characterRayAt({ evaluations, viewer }: Looking, { x, y }: PickPlace): Ray {
  const ray = rayThrough(viewer.camera.value, viewer.aspect, x, y);
  const shown = evaluations.selected();
  return shown ? characterRay(shown.display, ray) : ray;
}

/**
 * The joint at a place of the view, of the nearest actor there: of its bones or boxes where they are
 * shown, and where the skin hides them, the one that owns the skin there.
 */
export function boneAt(look: Looking, place: PickPlace): BoneTarget | null {
  let nearest: Hit | null = null;
  for (const evaluation of look.evaluations.all()) {
    const hit = hitOf(evaluation, look, place);
    if (hit && hit.sceneDistance < (nearest?.sceneDistance ?? Infinity)) nearest = hit;
  }
  return nearest?.target ?? null;
}

/** As `boneAt`, of the selected actor alone, and only where no other hides it. */
export function selectedBoneAt(look: Looking, place: PickPlace): BoneTarget | null {
  const target = boneAt(look, place);
  return target?.actorId === look.session.selectedActorId.value ? target : null;
}

/** What of an actor a place meets; skin that no joint owns is met too, and hides what is behind. */
interface Hit {
  readonly sceneDistance: number;
  readonly target: BoneTarget | null;
}

function hitOf(shown: Evaluation, look: Looking, place: PickPlace): Hit | null {
  const { session, viewer } = look;
  const { characterFromJoint, skin, display, state } = shown;
  const { character } = state;
  const camera = viewer.camera.value;
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

/** @param met the bone that was met; without one it is the nearest of those that start at the joint */
function atJoint(
  { state: { id, character }, characterFromJoint }: Evaluation,
  joint: number,
  ray: Ray,
  distance: number,
  met?: Bone | null,
): BoneTarget {
  const [x, y, z] = pointOnRay(ray, distance) as [number, number, number];
  const matrix = characterFromJoint.subarray(joint * 16, joint * 16 + 16);
  const own = character.bones.filter((bone) => bone.joint === joint);
  const gaps = own.map(({ vector }) => {
    const start = vec3.transformMat4(new Float64Array(3), [0, 0, 0], matrix);
    const end = vec3.transformMat4(new Float64Array(3), vector, matrix);
    return distanceToSegment([x, y, z], start, end);
  });
  const bone = met ?? own[gaps.indexOf(Math.min(...gaps))] ?? null;
  return { actorId: id, joint, bone, grabbed: [x, y, z], distance };
}
