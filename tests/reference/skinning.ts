import { normalAboutCenter, turnedAboutCenter } from './centers-of-rotation.ts';
import { deltaMushed, type MushedSurface, type SkinnedSurface } from './delta-mush.ts';
import {
  type DualQuaternion,
  inner,
  moved,
  rigidAndStretch,
  scaled,
  sum,
} from './dual-quaternions.ts';
import { inverse, type Matrix, transform, transpose, unit, type Vector } from './matrix.ts';
import { influencesOf, skinningMatrix, type Transforms, type Vertex } from './skinned-vertex.ts';

export interface MethodOracle {
  position(vertex: Vertex, transforms: Transforms): Vector;
  normal(vertex: Vertex, transforms: Transforms): Vector;
  /** For methods that need the whole surface. */
  finish?(surface: SkinnedSurface): MushedSurface;
}

/**
 * The handout, part 4: p′ = Σ w · T · B⁻¹ · p. Each joint moves the point rigidly, and the results
 * are averaged.
 */
const linearBlend: MethodOracle = {
  position(vertex, transforms) {
    const sum = [0, 0, 0];
    for (const [joint, weight] of influencesOf(vertex, transforms)) {
      const inJoint = transform(transforms.jointFromBind[joint]!, vertex.position);
      const moved = transform(transforms.characterFromJoint[joint]!, inJoint);
      moved.forEach((value, axis) => (sum[axis]! += weight * value));
    }
    return sum;
  },
  normal(vertex, transforms) {
    const blended = [0, 1, 2].map((row) =>
      [0, 1, 2].map((column) =>
        influencesOf(vertex, transforms).reduce(
          (sum, [joint, weight]) => sum + weight * skinningMatrix(joint, transforms)[row]![column]!,
          0,
        ),
      ),
    );
    return turnedNormal(blended, vertex.normal);
  },
};

/** CSE169, project 2: n′ = Σ w · (W · B⁻¹)⁻ᵀ · n, each joint on its own, then normalized. */
const jointNormals: MethodOracle = {
  position: (vertex, transforms) => linearBlend.position(vertex, transforms),
  normal(vertex, transforms) {
    const sum = [0, 0, 0];
    for (const [joint, weight] of influencesOf(vertex, transforms)) {
      const matrix = skinningMatrix(joint, transforms).slice(0, 3);
      const upright = transpose(inverse(matrix.map((row) => row.slice(0, 3))));
      upright.forEach((row, axis) => {
        row.forEach((value, k) => (sum[axis]! += weight * value * vertex.normal[k]!));
      });
    }
    return unit(sum);
  },
};

/** Every vertex moves only with the joint of its largest weight. */
const rigid: MethodOracle = {
  position: (vertex, transforms) =>
    transform(skinningMatrix(heaviest(vertex, transforms), transforms), vertex.position),
  normal(vertex, transforms) {
    const matrix = skinningMatrix(heaviest(vertex, transforms), transforms);
    return turnedNormal(
      matrix.slice(0, 3).map((row) => row.slice(0, 3)),
      vertex.normal,
    );
  },
};

/**
 * Kavan and others 2007: the dual quaternions of the joints are blended, each with the sign that
 * agrees with that of the largest weight, and normalized. What is left of the matrices is blended
 * linearly before. Negative weights count as 0; without a direction it is linear blend.
 */
const dualQuaternion: MethodOracle = {
  position(vertex, transforms) {
    const blend = blendedMotion(vertex, transforms);
    if (!blend) return linearBlend.position(vertex, transforms);
    return moved(blend.motion, timesVector(blend.stretch, vertex.position));
  },
  normal(vertex, transforms) {
    const blend = blendedMotion(vertex, transforms);
    if (!blend) return linearBlend.normal(vertex, transforms);
    const [rotation] = blend.motion;
    const onStretched = turnedNormal(blend.stretch, vertex.normal);
    return unit(moved([rotation, [0, 0, 0, 0]], onStretched));
  },
};

/** The parts of matrices that many vertices share, each computed once. */
const knownParts = new WeakMap<Matrix, ReturnType<typeof rigidAndStretch>>();

function partsOf(matrix: Matrix): ReturnType<typeof rigidAndStretch> {
  let parts = knownParts.get(matrix);
  if (!parts) knownParts.set(matrix, (parts = rigidAndStretch(matrix)));
  return parts;
}

function blendedMotion(
  vertex: Vertex,
  transforms: Transforms,
): { motion: DualQuaternion; stretch: Matrix } | null {
  const pivot = partsOf(skinningMatrix(heaviest(vertex, transforms), transforms));
  let [rotation, dual]: DualQuaternion = [
    [0, 0, 0, 0],
    [0, 0, 0, 0],
  ];
  const stretch = [0, 1, 2].map(() => [0, 0, 0]);
  const used = influencesOf(vertex, transforms).filter(([, weight]) => weight > 0);
  const total = used.reduce((weights, [, weight]) => weights + weight, 0);
  for (const [joint, weight] of used) {
    const part = partsOf(skinningMatrix(joint, transforms));
    const signed = inner(pivot.motion[0], part.motion[0]) < 0 ? -weight : weight;
    rotation = sum(rotation, scaled(part.motion[0], signed));
    dual = sum(dual, scaled(part.motion[1], signed));
    part.stretch.forEach((row, i) => {
      row.forEach((value, k) => (stretch[i]![k]! += (weight / total) * value));
    });
  }
  const length = Math.hypot(...rotation);
  if (length < 1e-6) return null;
  return { motion: [scaled(rotation, 1 / length), scaled(dual, 1 / length)], stretch };
}

function timesVector(matrix: Matrix, vector: Vector): number[] {
  return matrix.map((row) => row.reduce((total, value, k) => total + value * vector[k]!, 0));
}

const deltaMush: MethodOracle = { ...linearBlend, finish: (surface) => deltaMushed(surface) };

/** Oracles by the id of the method in the registry; a new method needs one here. */
export const methodOracles: Readonly<Record<string, MethodOracle | undefined>> = {
  'linear-blend': linearBlend,
  'joint-normals': jointNormals,
  rigid,
  'dual-quaternion': dualQuaternion,
  'centers-of-rotation': { position: turnedAboutCenter, normal: normalAboutCenter },
  'delta-mush': deltaMush,
};

function heaviest(vertex: Vertex, transforms: Transforms): number {
  const [first, ...others] = influencesOf(vertex, transforms);
  return others.reduce((best, next) => (next[1] > best[1] ? next : best), first!)[0];
}

/**
 * Transforms a normal by the inverse transpose, so that it stays perpendicular to a stretched
 * surface.
 */
function turnedNormal(matrix: Matrix, normal: Vector): Vector {
  const turned = transpose(inverse(matrix)).map((row) =>
    row.reduce((sum, value, k) => sum + value * normal[k]!, 0),
  );
  return unit(turned);
}
