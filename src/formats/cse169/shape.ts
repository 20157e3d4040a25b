import type { FormatShape } from '../format.ts';

/** Joints rotate by Rz · Ry · Rx. Each has a name, a pose, limits and its own binding. */
export const cse169Shape: FormatShape = {
  owner: 'CSE169',
  slides: 'roots',
  turns: 'zyx',
  restRotations: false,
  restPose: true,
  limits: true,
  jointNames: 'words',
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
  nests: true,
  metersPerUnit: null,
  handedness: 'right-handed',
};
