import type { ComparedMethod, Comparison } from '../../document/comparison.ts';
import { deformationOf } from '../../skinning/registry.ts';
import type { Overrides } from '../evaluations.ts';

/**
 * What differs from the scene in the view of a compared method. Normals stay those of each character,
 * so that shading shows no difference that the method does not make.
 */
export function overridesOf(
  method: ComparedMethod,
  { normalizeRows }: Pick<Comparison, 'normalizeRows'>,
): Overrides {
  const rows = normalizeRows ? { normalizeWeights: true } : {};
  if (method === 'own') return normalizeRows ? { deformation: rows } : {};
  const deformation = method === 'joint-normals' ? deformationOf(method) : { method };
  return { deformation: { ...deformation, ...rows } };
}
