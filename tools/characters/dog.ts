import { join } from 'node:path';
import type { Material } from './mit-text.ts';
import { moveBones, readJointPlaces, readMujocoSkin } from './mujoco-source.ts';
import { addRigidPart, boneOf, floorOf, makeFromSkin } from './source-skin.ts';
import { shrinkImage } from './shrink-image.ts';
import { readStl } from './stl-source.ts';
import type { Vector3 } from './vector.ts';

const MATERIALS: readonly Material[] = [
  { name: 'coat', color: [1, 0.98, 0.94], texture: 'dog.jpg' },
  { name: 'eyes', color: [0.16, 0.11, 0.08], gloss: [0.6, 90] },
];

/** MuJoCo's dog faces +x, with +y to its left and +z up. This turns it to face +z, with +y up. */
function turnUpright([x, y, z]: Vector3): Vector3 {
  return [y, z, x];
}

/**
 * Makes the dog from the folder `dm_control/suite` of the Python package dm-control: its skin, and
 * the eyes, which the model keeps separate from it. The skin's bones are bound at the origins of
 * bodies; they are moved to the positions of the model's joints (the head rotates about the atlas,
 * not about its own center). The middle of the paws is at the origin.
 */
export async function makeDog(sourceFolder: string, dataFolder: string): Promise<void> {
  const assets = join(sourceFolder, 'dog_assets');
  const body = readMujocoSkin(join(assets, 'dog_skin.skn'), 'coat');
  const eyes = ['L', 'R'].flatMap((side) => readStl(join(assets, `BONEeye_${side}.stl`)));
  const bound = addRigidPart(body, 'eyes', 'skull', eyes);
  const skin = moveBones(bound, readJointPlaces(join(sourceFolder, 'dog.xml')));
  const toes = (bone: string): number => turnUpright(boneOf(skin, bone).position)[2];
  const middle = (toes('finger_L') + toes('toe_L')) / 2;
  const floor = floorOf(skin, turnUpright);
  const place = (point: Vector3): Vector3 => {
    const [x, y, z] = turnUpright(point);
    return [x, y - floor, z - middle];
  };
  makeFromSkin('dog', skin, place, dataFolder, MATERIALS);
  const picture = { side: 512, quality: 0.8 };
  await shrinkImage(join(assets, 'skin_texture.png'), join(dataFolder, 'dog/dog.jpg'), picture);
}
