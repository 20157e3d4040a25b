import type { FormatShape } from '../format.ts';

/** Joints turn by Rz · Ry · Rx; each has a name, a pose, limits and a binding of its own. */
export const cse169Shape: FormatShape = {
  owner: 'CSE169',
  slides: 'roots',
  turns: 'zyx',
  restRotations: false,
  restPose: true,
  limits: true,
  jointNames: true,
  jointBoxes: true,
  bindings: true,
  firstJointWeights: true,
  influences: Infinity,
  normals: 'joints',
  ownNormals: true,
  textures: true,
  colors: false,
  morphs: true,
  clips: true,
  metersPerUnit: null,
  handedness: 'right-handed',
};
