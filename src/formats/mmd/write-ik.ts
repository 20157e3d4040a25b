import type { BinaryWriter } from '../binary/binary-writer.ts';
import type { IkChain } from './mmd-parts.ts';

/** Writes the IK chains, each with the bones that it turns. */
export function writeIkChains(out: BinaryWriter, chains: readonly IkChain[]): void {
  out.u16(chains.length);
  for (const { goal, effector, iterations, limit, links } of chains) {
    out.u16(goal, effector);
    out.u8(links.length);
    out.u16(iterations);
    out.f32(limit);
    out.u16(...links);
  }
}
