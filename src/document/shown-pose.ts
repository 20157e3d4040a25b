import type { Pose } from '../core/pose.ts';
import { poseLayers } from '../posing/layers.ts';
import { type CharacterState, selectedCharacter } from './document.ts';
import type { Session } from './session.ts';
import type { Store } from './store.ts';

/**
 * The pose that is shown: the edited one, under what the pose layers make of it at a time. While a clip
 * plays nothing is allocated: the same arrays are written again.
 *
 * @param time seconds of the bound clip
 * @returns to be read at once and not kept
 */
export function shownPose(state: CharacterState, time: number): Pose {
  const clip = state.clip === null ? null : state.character.clips[state.clip]!;
  const context = { clip, time };
  if (!poseLayers.some((layer) => layer.isActive(context))) return state;
  let latest = latestPoses.get(state);
  if (latest?.time === time) return latest.pose;
  if (!latest) {
    const { morphWeights } = state;
    latestPoses.set(state, (latest = { pose: { q: state.q.slice(), morphWeights }, time }));
  }
  latest.time = time;
  latest.pose.q.set(state.q);
  for (const layer of poseLayers) if (layer.isActive(context)) layer.apply(context, latest.pose.q);
  return latest.pose;
}

/** The selected character as it is shown at the moment. */
export function shownSelected(
  { document }: Store,
  { clipTime }: Session,
): { readonly state: CharacterState; readonly pose: Pose } | undefined {
  const state = selectedCharacter(document.value);
  return state && { state, pose: shownPose(state, clipTime.value) };
}

const latestPoses = new WeakMap<CharacterState, { readonly pose: Pose; time: number }>();
