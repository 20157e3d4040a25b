import { assert } from '../core/assert.ts';
import type { Character } from '../core/character.ts';
import { loadPart } from '../core/failure.ts';
import type { NormalsId } from '../core/skin.ts';
import type { FaceWeighting } from '../core/vertex-normals.ts';
import type { LaterKernelId } from './later-kernels.ts';
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

function row<Id extends LaterKernelId>(id: Id, label: string, short: string): KernelRow<Id> {
  const load = async () => (await loadPart(import('./later-kernels.ts'))).laterKernels[id]();
  return { id, label, short, load };
}

const otherMethods = [
  row('rigid', 'Rigid parts', 'rigid'),
  row('dual-quaternion', 'Dual quaternions', 'dqs'),
  row('centers-of-rotation', 'Centers of rotation', 'cor'),
  row('delta-mush', 'Delta mush', 'mush'),
];

/** Every kernel. */
export const kernels: readonly KernelRow[] = [
  linearBlendRow,
  row('joint-normals', 'Linear blend, CSE169 normals', 'lbs169'),
  ...otherMethods,
];

/** Every skinning method, as shown in the interface. */
export const methods: readonly KernelRow<MethodId>[] = [linearBlendRow, ...otherMethods];

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
  if (method === 'linear-blend' && normals === 'joints') return kernelById('joint-normals');
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
