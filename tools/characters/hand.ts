import { join } from 'node:path';
import { readGlb } from './glb-source.ts';
import { boneOf, floorOf, makeFromSkin } from './source-skin.ts';
import type { Vector3 } from './vector.ts';

/**
 * The angle between the source's flat cut through the forearm and a cut square to the fingers, in
 * radians.
 */
const CUT_TILT = 0.3358;

/**
 * In the source the fingers point along -y and the palm faces -x. This turns the fingers to +y and
 * the palm to +z, and leans the hand back until the cut is level, as a raised hand bends at the
 * wrist.
 */
function turnUpright([sourceX, sourceY, sourceZ]: Vector3): Vector3 {
  const [x, y, z] = [-sourceZ, -sourceY, -sourceX];
  const [cosine, sine] = [Math.cos(CUT_TILT), Math.sin(CUT_TILT)];
  return [x, cosine * y + sine * z, cosine * z - sine * y];
}

/**
 * Makes the hand from the folder `generic-hand` of the npm package @webxr-input-profiles/assets,
 * which stores its joints as siblings; `hand-joints.json` chains them. The cut through the forearm
 * is on the floor, and the wrist is above the origin.
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
