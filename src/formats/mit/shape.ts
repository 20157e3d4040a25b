import type { FormatShape } from '../format.ts';

/** Joints rotate by Rx · Ry · Rz. The mesh is bound to joints without rotation, in no pose. */
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
  textures: true,
  colors: true,
  morphs: false,
  clips: false,
  nests: false,
  metersPerUnit: null,
  handedness: 'right-handed',
};
