/** Names for skeletons whose files have none, recognized by their topology. */
export interface NamedTopology {
  /** File order. */
  readonly parents: readonly number[];
  readonly names: readonly string[];
}

/** MakeHuman's `cmu_mb` rig below a root without weights, as in the bundled human. */
export const makeHuman: NamedTopology = {
  parents: [
    -1, 0, 1, 2, 3, 4, 5, 6, 4, 8, 9, 10, 11, 12, 11, 4, 15, 16, 17, 18, 19, 18, 1, 22, 23, 24, 25,
    1, 27, 28, 29, 30,
  ],
  names: [
    'Root',
    'Hips',
    'Lower back',
    'Spine',
    'Chest',
    'Neck',
    'Upper neck',
    'Head',
    'Right shoulder',
    'Right upper arm',
    'Right forearm',
    'Right hand',
    'Right palm',
    'Right fingers',
    'Right thumb',
    'Left shoulder',
    'Left upper arm',
    'Left forearm',
    'Left hand',
    'Left palm',
    'Left fingers',
    'Left thumb',
    'Right hip',
    'Right upper leg',
    'Right lower leg',
    'Right foot',
    'Right toes',
    'Left hip',
    'Left upper leg',
    'Left lower leg',
    'Left foot',
    'Left toes',
  ],
};

export function hasTopology(topology: NamedTopology, parents: readonly number[]): boolean {
  const { length } = parents;
  return (
    topology.parents.length === length && parents.every((each, i) => each === topology.parents[i])
  );
}
