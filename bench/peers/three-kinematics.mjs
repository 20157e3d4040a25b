import { Bone } from 'three';

/** Writes the world matrices of a tree of joints. */
export function threeKinematics(parents, offsets) {
  const bones = parents.map(() => new Bone());
  parents.forEach((parent, i) => {
    bones[i].position.fromArray(offsets, 3 * i);
    if (parent >= 0) bones[parent].add(bones[i]);
  });
  return {
    run(angles) {
      for (let i = 0; i < bones.length; i++) {
        bones[i].rotation.set(angles[3 * i], angles[3 * i + 1], angles[3 * i + 2]);
      }
      bones[0].updateMatrixWorld();
    },
    matrices: () => Float64Array.from(bones.flatMap((bone) => bone.matrixWorld.elements)),
  };
}
