import { mat3, mat4, vec3 } from 'gl-matrix';
import { applyRest } from '../core/joint-transforms.ts';
import { noParent } from '../core/skeleton.ts';
import type { DisplayTransform } from '../evaluation/display-transform.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import type { JointNature } from '../posing/ik/problem.ts';
import { presentAngles } from '../posing/natural/natural-skeleton.ts';
import { naturesInUse } from '../posing/natural/natures-in-use.ts';
import type { RingPlace } from '../posing/ring-turn.ts';
import { type OverlayView, pixelSizeAt } from './overlay.ts';
import type { SessionOptions } from './view-options.ts';

/** The joint whose nature is shown. */
export interface NatureLook {
  readonly joint: number;
  /** Of the sector of bending, in CSS pixels. */
  readonly radius: number;
}

/** A soft range of a joint as it is placed in the scene: angle 0 is toward `first`. */
export interface NatureArc extends RingPlace {
  readonly name: 'bend' | 'side' | 'twist';
  /** Radians. */
  readonly range: readonly [number, number];
  /** The joint's present angle. */
  readonly value: number;
}

const fullTurn = 2 * Math.PI;
/** In CSS pixels: for a mouse, and for fingers. Both are shorter than the arrows of a target. */
const [mouseRadius, touchRadius] = [54, 80];
/** As parts of the radius: of the arcs of side and twist, and how far from the joint that of twist is. */
const [sidePart, twistPart, twistAlong] = [0.84, 0.3, 0.6];
/** Sideways bends and twists that are narrower than this tell nothing. */
const narrow = (12 * Math.PI) / 180;

/** Soft ranges are shown where inverse kinematics would keep to them. */
export function natureLookOf(options: SessionOptions): NatureLook | null {
  const { showOverlay, ikMode, selectedJoint, playing, posesBy, byTouch, ikSketch } = options;
  if (!showOverlay || !ikMode || playing || posesBy === 'mode' || ikSketch) return null;
  if (selectedJoint === null) return null;
  return { joint: selectedJoint, radius: byTouch ? touchRadius : mouseRadius };
}

/**
 * Returns the soft ranges of a joint around its place, of a constant radius in the picture: the bend
 * in the plane of bending, with angle 0 along the limb as it is at rest and the present value where
 * the limb is; the side across it, from where the limb is bent to; and the twist around the limb. A range
 * that allows everything is left out, and so are narrow ones of side and twist.
 */
export function natureArcs(
  { state, pose, characterFromJoint, display }: Evaluation,
  view: OverlayView,
  { joint, radius }: NatureLook,
): readonly NatureArc[] {
  const { character, natures } = state;
  const nature = naturesInUse(character, natures).find((each) => each.joint === joint);
  if (!nature) return [];
  const { skeleton } = character;
  const atRest = new Float64Array(16);
  const parent = skeleton.parents[joint]!;
  if (parent === noParent) mat4.identity(atRest);
  else atRest.set(characterFromJoint.subarray(parent * 16, parent * 16 + 16));
  applyRest(skeleton, joint, atRest);
  const present = characterFromJoint.slice(joint * 16, joint * 16 + 16);
  const center = present.slice(12, 15);
  vec3.transformMat4(center, center, display.sceneFromCharacter);
  const length = radius * pixelSizeAt(view, center);
  if (length <= 0) return [];

  const [bend, side, twist] = presentAngles(skeleton, nature, pose.q);
  const arcs: NatureArc[] = [];
  const resting = axesIn(display, atRest, nature);
  if (isUseful(nature.bend, 0)) {
    const place = { center, first: resting(0, 0, length), second: resting(0, -length, 0) };
    arcs.push({ name: 'bend', ...place, range: nature.bend, value: bend });
  }
  if (isUseful(nature.side, narrow)) {
    const size = length * sidePart;
    const first = resting(0, -Math.sin(bend) * size, Math.cos(bend) * size);
    const place = { center, first, second: resting(size, 0, 0) };
    arcs.push({ name: 'side', ...place, range: nature.side, value: side });
  }
  if (isUseful(nature.twist, narrow)) {
    const turned = axesIn(display, present, nature);
    const around = vec3.add(new Float64Array(3), center, turned(0, 0, length * twistAlong));
    // Angle 0 is where the limb's own y would point without the twist.
    const size = length * twistPart;
    const [sin, cos] = [Math.sin(twist) * size, Math.cos(twist) * size];
    const place = { center: around, first: turned(-sin, -cos, 0), second: turned(cos, -sin, 0) };
    arcs.push({ name: 'twist', ...place, range: nature.twist, value: twist });
  }
  return arcs;
}

/** Whether a range is at least this wide, and does not allow everything. */
function isUseful([low, high]: readonly [number, number], least: number): boolean {
  return high - low >= least && high - low < fullTurn;
}

/**
 * Returns a function from vectors in a nature's axes to the scene, without its scale.
 *
 * @param characterFromFrame the joint's frame, at rest or as it is
 */
function axesIn(
  { sceneFromCharacter, scale }: DisplayTransform,
  characterFromFrame: mat4,
  { jointFromNature }: JointNature,
): (x: number, y: number, z: number) => vec3 {
  const matrix = mat4.multiply(new Float64Array(16), sceneFromCharacter, characterFromFrame);
  const linear = mat3.fromMat4(new Float64Array(9), matrix);
  return (x, y, z) => {
    const vector = Float64Array.of(x / scale, y / scale, z / scale);
    vec3.transformQuat(vector, vector, [...jointFromNature]);
    return vec3.transformMat3(vector, vector, linear);
  };
}
