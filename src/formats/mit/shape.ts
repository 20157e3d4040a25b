import type { FormatShape } from '../format.ts';

/** Joints turn by Rx · Ry · Rz and stand unturned, in no pose, where the mesh is bound. */
export const mitShape: FormatShape = {
  owner: '6.837',
  slides: 'roots',
  turns: 'xyz',
  restRotations: false,
  restPose: false,
  limits: false,
  jointNames: false,
  jointBoxes: false,
  bindings: false,
  firstJointWeights: false,
  influences: Infinity,
  normals: 'blended',
  ownNormals: false,
  textures: false,
  colors: false,
  morphs: false,
  clips: false,
  metersPerUnit: null,
  handedness: 'right-handed',
};
