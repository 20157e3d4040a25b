import { assert } from '../core/assert.ts';
import type { Character } from '../core/character.ts';
import { loadPart } from '../core/failure.ts';
import type { NormalsId } from '../core/skin.ts';
import type { FaceWeighting } from '../core/vertex-normals.ts';
import { linearBlend } from './linear-blend.ts';
import type { KernelId, MethodId, MethodSettings, SkinningMethod } from './method.ts';

/**
 * A kernel (a method with a way of normals) as data; its code is loaded when it is first needed.
 */
export interface KernelRow<Id extends KernelId = KernelId> {
  readonly id: Id;
  readonly label: string;
  /** What one types for it, beside its id. */
  readonly short: string;
  readonly load: () => Promise<SkinningMethod<Id>>;
}

const linearBlendRow: KernelRow<'linear-blend'> = {
  id: 'linear-blend',
  label: 'Linear blend (SSD)',
  short: 'lbs',
  // It replaces other kernels while they load, so it must always be available.
  load: () => Promise.resolve(linearBlend),
};

const jointNormalsRow: KernelRow<'joint-normals'> = {
  id: 'joint-normals',
  label: 'Linear blend, CSE169 normals',
  short: 'lbs169',
  load: async () => (await loadPart(import('./joint-normals.ts'))).jointNormals,
};

const rigidRow: KernelRow<'rigid'> = {
  id: 'rigid',
  label: 'Rigid parts',
  short: 'rigid',
  load: async () => (await loadPart(import('./rigid.ts'))).rigid,
};

const dualQuaternionRow: KernelRow<'dual-quaternion'> = {
  id: 'dual-quaternion',
  label: 'Dual quaternions',
  short: 'dqs',
  load: async () => (await loadPart(import('./dual-quaternion.ts'))).dualQuaternion,
};

const centersOfRotationRow: KernelRow<'centers-of-rotation'> = {
  id: 'centers-of-rotation',
  label: 'Centers of rotation',
  short: 'cor',
  load: async () => (await loadPart(import('./centers-of-rotation.ts'))).centersOfRotation,
};

const deltaMushRow: KernelRow<'delta-mush'> = {
  id: 'delta-mush',
  label: 'Delta mush',
  short: 'mush',
  load: async () => (await loadPart(import('./delta-mush.ts'))).deltaMush,
};

/** Every kernel. */
export const kernels: readonly KernelRow[] = [
  linearBlendRow,
  jointNormalsRow,
  rigidRow,
  dualQuaternionRow,
  centersOfRotationRow,
  deltaMushRow,
];

/** Every skinning method, as shown in the interface. */
export const methods: readonly KernelRow<MethodId>[] = [
  linearBlendRow,
  rigidRow,
  dualQuaternionRow,
  centersOfRotationRow,
  deltaMushRow,
];

/** Every way in which normals follow, as shown in the interface. */
export const normalWays: readonly { readonly id: NormalsId; readonly label: string }[] = [
  { id: 'blended', label: 'blended' },
  { id: 'joints', label: 'per joint (CSE169)' },
  { id: 'faces', label: 'mean of faces (6.837)' },
  { id: 'area', label: 'mean of faces by area' },
  { id: 'angle', label: 'mean of faces by angle' },
];

/** How normals are recomputed from the posed faces, or null if they are transformed with the skin. */
export function recomputedNormals(normals: NormalsId): FaceWeighting | null {
  return normals === 'blended' || normals === 'joints' ? null : normals;
}

/** How a character is deformed: a method and a way of normals. */
export interface Deformation {
  readonly method: MethodId;
  readonly normals: NormalsId;
  /** Those of the actor, if absent. */
  readonly methodSettings?: MethodSettings;
  readonly normalizeWeights?: boolean;
}

/** The deformation that the programs of the character's own format use. */
export function defaultDeformation({ skin }: Pick<Character, 'skin'>): Deformation {
  return { method: 'linear-blend', normals: skin.normals };
}

/** Under rigid parts a vertex has one matrix, so both ways give the same normals. */
export function kernelOf({ method, normals }: Deformation): KernelRow {
  if (method === 'linear-blend' && normals === 'joints') return jointNormalsRow;
  return kernelById(method);
}

export function deformationOf(id: KernelId): Deformation {
  return id === 'joint-normals'
    ? { method: 'linear-blend', normals: 'joints' }
    : { method: id, normals: 'blended' };
}

export function kernelById(id: KernelId): KernelRow {
  const kernel = kernels.find((candidate) => candidate.id === id);
  assert(kernel !== undefined, `a skinning kernel named ${id}`);
  return kernel;
}

/** The kernel with this id or short name, if there is one. */
export function kernelNamed(name: string): KernelRow | undefined {
  return kernels.find(({ id, short }) => name === id || name === short);
}

/** The long name with the short one behind it. */
export function menuName({ label, short }: KernelRow): string {
  return `${label} · ${short}`;
}
