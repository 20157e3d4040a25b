import { buildSkeleton } from '../../../src/core/build-skeleton.ts';
import type {
  CharacterParts,
  JointParts,
  MeshParts,
  SkeletonParts,
  SkinParts,
} from '../../../src/core/character-parts.ts';
import { DiagnosticLog } from '../../../src/core/diagnostics.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { defaultLimits } from '../../../src/core/limits.ts';
import { ballHinges, rootSlides } from '../../../src/formats/cse169/joint-dofs.ts';
import { roundWeights } from '../mit-text.ts';
import type { Vector3 } from '../vector.ts';
import { bodyJoints } from './body.ts';
import { headJoints } from './head.ts';
import type { InsectJoint } from './joints.ts';
import { legJoints } from './legs.ts';
import { standing } from './pose.ts';
import { insectSurface, normalsOf, rounded } from './surface.ts';
import { wingJoints } from './wings.ts';
import type { Surface } from './sweep.ts';

/** In depth-first order, as in the file. */
export const insectJoints: readonly InsectJoint[] = [
  ...bodyJoints(),
  ...headJoints(),
  ...wingJoints(),
  ...legJoints(),
];

const triple = ([x, y, z]: Vector3): [number, number, number] => [x, y, z];
const indexOf = new Map(insectJoints.map(({ name }, index) => [name, index]));

/** Returns the skeleton with this pose in its file; offsets are in the parents' frames. */
function skeletonParts(pose: (joint: InsectJoint) => Vector3): SkeletonParts {
  const turn = new Map<string, number>([['', 0]]);
  const joints = insectJoints.map((joint): JointParts => {
    const { name, parent, position, bind, limits } = joint;
    const from = insectJoints[indexOf.get(parent) ?? -1]?.position ?? [0, 0, 0];
    const [x, y, z] = [position[0] - from[0], position[1] - from[1], position[2] - from[2]];
    // Only limbs are bound rotated, and only about z, so their angles add up.
    const angle = turn.get(parent)!;
    turn.set(name, angle + bind[2]);
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const offset: Vector3 = [c * x + s * y, c * y - s * x, z];
    const hinges = ballHinges(triple(pose(joint)), limits);
    return {
      name,
      fileName: name,
      parent: indexOf.get(parent) ?? -1,
      restOffset: triple(rounded(offset, 5) as unknown as Vector3),
      dofs: parent === '' ? [...rootSlides, ...hinges] : hinges,
    };
  });
  return { file: 'insect.skel', joints };
}

/** (jointCount × 16) column-major: the world matrices of the joints while the mesh is bound. */
function bindMatrices(): Float64Array {
  const unlimited = skeletonParts(({ bind }) => bind);
  const skeleton = buildSkeleton(unlimited, new DiagnosticLog('insect.skel'), defaultLimits);
  if (!skeleton) throw new Error('the skeleton could not be built');
  return Float64Array.from(rounded(jointMatrices(skeleton, skeleton.qRest), 6));
}

const WEIGHT_STEPS = 10_000;

/** Weights are whole ten-thousandths, so that a row sums to 1. */
function skinParts(surface: Surface, bindFromJoint: Float64Array): SkinParts {
  const start = [0];
  const joints: number[] = [];
  const weights: number[] = [];
  for (const row of surface.weights) {
    const steps = roundWeights(
      row.map(([, weight]) => weight),
      WEIGHT_STEPS,
    );
    row.forEach(([joint], index) => {
      if (steps[index] === 0) return;
      joints.push(indexOf.get(joint)!);
      weights.push(steps[index]! / WEIGHT_STEPS);
    });
    start.push(joints.length);
  }
  return {
    file: 'insect.skin',
    start: Uint32Array.from(start),
    joints: Uint16Array.from(joints),
    weights: Float32Array.from(weights),
    bindFromJoint,
  };
}

/** Boxes around the vertices that follow a joint most, in the joint's frame. */
function boxes(
  { positions }: Surface,
  skin: SkinParts,
  bindFromJoint: Float64Array,
): (readonly number[])[] {
  const found = insectJoints.map(() => [
    Infinity,
    Infinity,
    Infinity,
    -Infinity,
    -Infinity,
    -Infinity,
  ]);
  positions.forEach((point, vertex) => {
    let most = skin.start[vertex]!;
    for (let i = most; i < skin.start[vertex + 1]!; i++) {
      if (skin.weights[i]! > skin.weights[most]!) most = i;
    }
    const joint = skin.joints[most]!;
    const bind = bindFromJoint.subarray(joint * 16, joint * 16 + 16);
    for (let axis = 0; axis < 3; axis++) {
      // Bind matrices are rigid, so the dot product with an axis is the coordinate along it.
      const value = [0, 1, 2].reduce(
        (sum, k) => sum + (point[k]! - bind[12 + k]!) * bind[axis * 4 + k]!,
        0,
      );
      const box = found[joint]!;
      box[axis] = Math.min(box[axis]!, value);
      box[axis + 3] = Math.max(box[axis + 3]!, value);
    }
  });
  return found.map((box) => rounded(box, 4));
}

function meshParts(surface: Surface): MeshParts {
  const corners = surface.triangles.flat();
  return {
    file: 'insect.skin',
    positions: Float32Array.from(rounded(surface.positions.flat(), 4)),
    normals: Float32Array.from(normalsOf(surface)),
    uvs: Float32Array.from(rounded(surface.textureCoordinates.flat(), 4)),
    cornerPoints: Uint32Array.from(corners),
    cornerNormals: Int32Array.from(corners),
    cornerUvs: Int32Array.from(corners),
    materials: [{ name: 'insect', texture: 'insect.png' }],
    submeshes: [{ material: 'insect', firstTriangle: 0 }],
  };
}

/** Returns the insect's skeleton, mesh and weights for its files. */
export function insectParts(): CharacterParts {
  const surface = insectSurface({ breath: 0, alert: 0 });
  const bindFromJoint = bindMatrices();
  const skin = skinParts(surface, bindFromJoint);
  const box = boxes(surface, skin, bindFromJoint);
  const pose = standing();
  const skeleton = skeletonParts(({ name }) => {
    return rounded(pose.get(name) ?? [0, 0, 0], 4) as unknown as Vector3;
  });
  return {
    name: 'insect',
    skeleton: {
      ...skeleton,
      joints: skeleton.joints.map((joint, index) => ({ ...joint, displayBox: box[index]! })),
    },
    mesh: meshParts(surface),
    skin,
    missing: [],
  };
}
