/** What a joint is in a body, as far as a solver has to know. It is named by what turns there. */
export type JointRole =
  | 'root'
  | 'pelvis'
  | 'spine'
  | 'neck'
  | 'head'
  | 'clavicle'
  | 'shoulder'
  | 'elbow'
  | 'wrist'
  | 'hip'
  | 'knee'
  | 'ankle'
  | 'toe'
  | 'finger'
  | 'thumb'
  | 'twist';

/** The roles of arms and legs, which only a body with two of each has. */
export const limbRoles: ReadonlySet<JointRole> = new Set<JointRole>([
  'clavicle',
  'shoulder',
  'elbow',
  'wrist',
  'hip',
  'knee',
  'ankle',
  'toe',
  'twist',
]);
