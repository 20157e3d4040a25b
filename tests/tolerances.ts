/** Every tolerance that a test compares with, named once. */
export const tolerances = {
  /** Forward kinematics and bind inverses against the float64 oracle, × reach. */
  kinematics: 1e-12,
  /** |T · B⁻¹ − I| at the file's pose. */
  bindError: 1e-12,
  /** A CPU method against the float64 oracle, × bounding diagonal. */
  skinning: 1e-6,
  /** Unit normals against the float64 oracle, per component. */
  normals: 1e-5,
  /** Posed reference files, model units: the models are about one unit tall. */
  referenceFiles: 1e-6,
  /** The same for the Virtual Mannequin's files, whose characters are about twenty units tall. */
  mannequinFiles: 2e-4,
  /** Reference frames of bones, per element. */
  boneFrames: 1e-5,
  /** Reference matrices, per element. */
  referenceMatrices: 1e-6,
  /** Reference matrices of planar shadows and mirrors, and points that they move. */
  planar: 1e-9,
  /** Geometry that is exact except for float32 rounding (areas, unit lengths). */
  float32: 1e-6,
  /** Distances to bones in the reference table, model units. */
  rayDistance: 1e-4,
  /** Points that stay fixed when a joint turns or rolls, and rotations that should be equal. */
  turn: 1e-9,
  /** Vertices of a mirrored pose against the mirrored vertices, model units. */
  mirrored: 1e-5,
  /** Residuals of inverse kinematics that count as reached, × the length of the chain. */
  reached: 1e-3,
} as const;
