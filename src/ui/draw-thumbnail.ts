import type { Actor } from '../document/scene.ts';
import { restPose } from '../core/pose.ts';
import { fitPose } from '../posing/fit-pose.ts';
import type { NamedPose } from '../posing/named-pose.ts';
import type { Picture } from '../view/picture/encode-picture.ts';
import { posePicture } from '../view/picture/pose-picture.ts';
import type { Looking } from './editor.ts';

/** In CSS pixels. */
const side = 96;

/** By the pose and how the character looks; neither ever changes. */
const pictures = new WeakMap<NamedPose, WeakMap<object, Map<string, Picture>>>();

/** One is drawn after another, so that the page goes on between them. */
let last: Promise<unknown> = Promise.resolve();

/** Draws a pose of a character onto a canvas, where it is not shown already. */
export function drawThumbnail(
  editor: Pick<Looking, 'viewer' | 'evaluations'>,
  actor: Actor,
  pose: NamedPose,
  canvas: HTMLCanvasElement,
): Promise<void> {
  const drawn = last.then(async () => {
    await editor.evaluations.settled();
    await new Promise((resolve) => setTimeout(resolve));
    if (!canvas.isConnected || !editor.viewer.available.value) return;
    const { width, height, pixels } = pictureOf(editor, actor, pose);
    canvas.width = width;
    canvas.height = height;
    canvas.getContext('2d')?.putImageData(new ImageData(pixels, width, height), 0, 0);
  });
  last = drawn.catch(() => undefined); // the failure is reported by who waits for this one
  return drawn;
}

function pictureOf({ viewer }: Pick<Looking, 'viewer'>, actor: Actor, pose: NamedPose): Picture {
  const { character, look, method } = actor;
  let ofPose = pictures.get(pose);
  if (!ofPose) pictures.set(pose, (ofPose = new WeakMap<object, Map<string, Picture>>()));
  let ofLook = ofPose.get(character);
  if (!ofLook) ofPose.set(character, (ofLook = new Map<string, Picture>()));
  const { image, visible, ...plain } = look;
  const key = JSON.stringify([plain, method, image?.name, visible]);
  const known = ofLook.get(key);
  if (known) return known;
  const { skeleton, morphs } = character;
  const rest = { ...restPose(skeleton), morphWeights: new Float64Array(morphs.length) };
  const { pose: posed, joints } = fitPose(character, rest, pose);
  const isWhole = joints.length === pose.joints.length && pose.joints.length >= movable(actor);
  const density = Math.min(2, window.devicePixelRatio);
  const pixels = Math.round(side * density);
  const drawn = posePicture(viewer, { ...actor, ...posed }, isWhole ? [] : joints, pixels);
  ofLook.set(key, drawn);
  return drawn;
}

/** The count of joints that have values. */
function movable({ character: { skeleton } }: Actor): number {
  const { dofStart, jointCount } = skeleton;
  let count = 0;
  for (let joint = 0; joint < jointCount; joint++) {
    if (dofStart[joint]! < dofStart[joint + 1]!) count++;
  }
  return count;
}
