import type { PoseCodec } from '../pose-formats.ts';
import { fitVpd } from './fit-vpd.ts';
import { readVpd } from './vpd.ts';
import { writeVpdPose } from './write-vpd-pose.ts';

/** Poses of MikuMikuDance. */
export const vpdCodec: PoseCodec = {
  read(file, bytes, character, shown) {
    const { value: vpd, diagnostics } = readVpd(file, bytes);
    if (!vpd) return { diagnostics };
    const fitted = fitVpd(file, vpd, character, shown);
    return { ...fitted, diagnostics: [...diagnostics, ...fitted.diagnostics] };
  },
  write: writeVpdPose,
};
