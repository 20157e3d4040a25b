import { hasTopology, makeHuman, type NamedTopology } from './human-joint-names.ts';

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

/** WebXR's hand joints as a chain, below a root without weights, as in the bundled hand. */
const hand: NamedTopology = {
  parents: [
    -1, 0, 1, 2, 3, 4, 1, 6, 7, 8, 9, 1, 11, 12, 13, 14, 1, 16, 17, 18, 19, 1, 21, 22, 23, 24,
  ],
  names: [
    'Root',
    'Wrist',
    'Thumb metacarpal',
    'Thumb proximal',
    'Thumb distal',
    'Thumb tip',
    'Index metacarpal',
    'Index proximal',
    'Index intermediate',
    'Index distal',
    'Index tip',
    'Middle metacarpal',
    'Middle proximal',
    'Middle intermediate',
    'Middle distal',
    'Middle tip',
    'Ring metacarpal',
    'Ring proximal',
    'Ring intermediate',
    'Ring distal',
    'Ring tip',
    'Little metacarpal',
    'Little proximal',
    'Little intermediate',
    'Little distal',
    'Little tip',
  ],
};

/** dm_control's dog below a root without weights, as in the bundled dog. */
const dog: NamedTopology = {
  parents: [
    -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 9, 14, 15, 16, 9, 18, 19, 20, 21, 22, 23, 24, 25,
    26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 1, 39, 40, 41, 42, 43, 44, 45, 46, 1, 48, 49,
    50, 51, 1, 53, 54, 55, 56,
  ],
  names: [
    'Root',
    'Chest',
    'Lower back 1',
    'Lower back 2',
    'Lower back 3',
    'Lower back 4',
    'Lower back 5',
    'Lower back 6',
    'Lower back 7',
    'Hips',
    'Left hind upper leg',
    'Left hind lower leg',
    'Left hind foot',
    'Left hind toes',
    'Right hind upper leg',
    'Right hind lower leg',
    'Right hind foot',
    'Right hind toes',
    'Tail 1',
    'Tail 2',
    'Tail 3',
    'Tail 4',
    'Tail 5',
    'Tail 6',
    'Tail 7',
    'Tail 8',
    'Tail 9',
    'Tail 10',
    'Tail 11',
    'Tail 12',
    'Tail 13',
    'Tail 14',
    'Tail 15',
    'Tail 16',
    'Tail 17',
    'Tail 18',
    'Tail 19',
    'Tail 20',
    'Tail 21',
    'Neck 1',
    'Neck 2',
    'Neck 3',
    'Neck 4',
    'Neck 5',
    'Neck 6',
    'Neck 7',
    'Head',
    'Lower jaw',
    'Left shoulder',
    'Left front upper leg',
    'Left front lower leg',
    'Left front foot',
    'Left front toes',
    'Right shoulder',
    'Right front upper leg',
    'Right front lower leg',
    'Right front foot',
    'Right front toes',
  ],
};

const topologies: readonly NamedTopology[] = [course, makeHuman, hand, dog];

/**
 * Returns unique names: the known ones if the topology is known, otherwise "joint 00", "joint 01",
 * …
 */
export function jointNames(parents: readonly number[]): readonly string[] {
  const known = topologies.find((topology) => hasTopology(topology, parents));
  if (known) return known.names;
  const width = Math.max(2, String(parents.length - 1).length);
  return parents.map((_, index) => `joint ${String(index).padStart(width, '0')}`);
}
