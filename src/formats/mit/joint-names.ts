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

const topologies: readonly NamedTopology[] = [course];

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
