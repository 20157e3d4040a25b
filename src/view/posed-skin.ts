import { type CharacterState, skinInUse } from '../document/document.ts';
import { shownPose } from '../document/shown-pose.ts';
import { methodById } from '../skinning/registry.ts';
import { skinVertices } from '../skinning/skin-vertices.ts';

/**
 * (vertexCount × 3) positions as posed, by the CPU, for picking: computed once for a pose.
 *
 * @param time seconds of the bound clip
 */
export function posedPositions(state: CharacterState, time: number): Float32Array {
  const kept = latestPositions.get(state);
  if (kept && (state.clip === null || kept.time === time)) return kept.positions;
  const method = methodById(state.method);
  const { positions } = skinVertices(
    state.character,
    skinInUse(state),
    shownPose(state, time),
    method,
  );
  latestPositions.set(state, { time, positions });
  return positions;
}

const latestPositions = new WeakMap<
  CharacterState,
  { readonly time: number; readonly positions: Float32Array }
>();
