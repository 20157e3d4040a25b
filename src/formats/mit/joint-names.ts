/** Names for skeletons whose files have none, told by their topology. */
interface NamedTopology {
  /** File order. */
  readonly parents: readonly number[];
  readonly names: readonly string[];
}

/** The skeleton of all the course's models, with the names of its starter program. */
const course: NamedTopology = {
  parents: [-1, 0, 1, 0, 2, 4, 5, 6, 2, 8, 9, 10, 0, 12, 13, 0, 15, 16],
  names: [
    'Root',
    'Chest',
    'Waist',
    'Neck',
    'Right hip',
    'Right leg',
    'Right knee',
    'Right foot',
    'Left hip',
    'Left leg',
    'Left knee',
    'Left foot',
    'Right collarbone',
    'Right shoulder',
    'Right elbow',
    'Left collarbone',
    'Left shoulder',
    'Left elbow',
  ],
};

/** MakeHuman's `cmu_mb` rig behind a weightless root, as the bundled human has it. */
const makeHuman: NamedTopology = {
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

const topologies: readonly NamedTopology[] = [course, makeHuman];

/** Unique names: the known ones where the topology is known, else "joint 00", "joint 01", … */
export function jointNames(parents: readonly number[]): readonly string[] {
  const known = topologies.find((topology) => sameNumbers(topology.parents, parents));
  if (known) return known.names;
  const width = Math.max(2, String(parents.length - 1).length);
  return parents.map((_, index) => `joint ${String(index).padStart(width, '0')}`);
}

function sameNumbers(a: readonly number[], b: readonly number[]): boolean {
  return a.length === b.length && a.every((value, index) => value === b[index]);
}
