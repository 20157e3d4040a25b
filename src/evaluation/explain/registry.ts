import type { KernelId } from '../../skinning/method.ts';
import { explainCentersOfRotation } from './centers-of-rotation.ts';
import { explainDeltaMush } from './delta-mush.ts';
import { explainDualQuaternion } from './dual-quaternion.ts';
import type { Explain } from './explanation.ts';
import { explainLinearBlend } from './linear-blend.ts';
import { explainRigid } from './rigid.ts';

/** How each kernel is explained; a new kernel is not compiled without its row. */
export const explainers: Readonly<Record<KernelId, Explain>> = {
  'linear-blend': explainLinearBlend,
  'joint-normals': explainLinearBlend,
  rigid: explainRigid,
  'dual-quaternion': explainDualQuaternion,
  'centers-of-rotation': explainCentersOfRotation,
  'delta-mush': explainDeltaMush,
};
