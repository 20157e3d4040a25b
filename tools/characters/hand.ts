import { join } from 'node:path';
import { readGlb } from './glb-source.ts';
import { boneOf, floorOf, makeFromSkin } from './source-skin.ts';
import type { Vector3 } from './vector.ts';

/** How far the source's flat cut through the forearm is from square to the fingers, radians. */
const CUT_TILT = 0.3358;

/**
 * The source's fingers point along -y, its palm to -x: fingers to +y, palm to +z, and leant back so
 * that the cut is level, as a raised hand is bent at the wrist.
 */
function turnUpright([sourceX, sourceY, sourceZ]: Vector3): Vector3 {
  const [x, y, z] = [-sourceZ, -sourceY, -sourceX];
  const [cosine, sine] = [Math.cos(CUT_TILT), Math.sin(CUT_TILT)];
  return [x, cosine * y + sine * z, cosine * z - sine * y];
}

/**
 * Makes the hand from the folder `generic-hand` of the npm package @webxr-input-profiles/assets,
 * which stores its joints side by side; `hand-joints.json` chains them. The cut through the forearm
 * stands on the floor, the wrist above the origin.
 */
export function makeHand(sourceFolder: string, dataFolder: string): void {
  const skin = readGlb(join(sourceFolder, 'right.glb'), 'hand');
  const [wristX, , wristZ] = turnUpright(boneOf(skin, 'wrist').position);
  const floor = floorOf(skin, turnUpright);
  const place = (point: Vector3): Vector3 => {
    const [x, y, z] = turnUpright(point);
    return [x - wristX, y - floor, z - wristZ];
  };
  makeFromSkin('hand', skin, place, dataFolder);
}
