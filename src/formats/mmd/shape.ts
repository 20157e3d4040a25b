import type { FormatShape } from '../format.ts';

/** Bones rotate as balls, without limits, and are bound in their rest position. */
export const mmdShape: FormatShape = {
  owner: 'MikuMikuDance',
  slides: 'any',
  turns: 'ball',
  restRotations: false,
  restPose: false,
  limits: false,
  jointNames: 'fields',
  jointBoxes: false,
  bindings: false,
  firstJointWeights: true,
  influences: 2,
  normals: 'blended',
  ownNormals: true,
  textures: true,
  colors: true,
  morphs: true,
  clips: false,
  nests: false,
  metersPerUnit: null,
  handedness: 'left-handed',
};
