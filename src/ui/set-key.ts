import { printable } from '../core/diagnostics.ts';
import { jointOfValue, jointRange } from '../core/pose.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { animatedBy } from '../document/animated.ts';
import { keyPlace } from '../document/key-time.ts';
import { keyValues } from '../document/keying.ts';
import type { KeyedThings } from '../document/keying-targets.ts';
import { type Actor, boundClip } from '../document/scene.ts';
import { selectedJoints } from '../document/selected-joints.ts';
import { shownState } from '../evaluation/shown-state.ts';
import type { Editor } from './editor.ts';

/** What `k` keys, and what it is called. */
interface Chosen extends KeyedThings {
  readonly name: string;
}

/**
 * Sets keys at the playhead: of what is unkeyed, else of the selected joints with their pins, else
 * of all values, of the morphs that are used and of all pins.
 */
export function setKeyHere(editor: Editor): void {
  const { store, session, evaluations, notice } = editor;
  const shown = evaluations.selected();
  if (!shown) return;
  const actor = shown.state;
  const { name, ...what } = chosen(actor, selectedJoints(session));
  if (what.values.length + what.morphs.length + what.pins.length === 0) {
    notice.value = `${printable(actor.name, 40)} has nothing to key`;
    return;
  }
  const place = keyPlace(store.scene.value, session, actor);
  const { clip, time } = place;
  const isNew = actor.clips[clip] === undefined;
  const edit = keyValues(actor, clip, time, shownState(shown), what, `Key ${name}`);
  store.dispatch(edit);
  session.playing.value = false;
  session.clipTime.value = time;
  const made = isNew ? ', in a new clip' : '';
  const keyed = `${name[0]!.toUpperCase()}${name.slice(1)} keyed at ${time.toFixed(2)} s${made}`;
  // Screen readers announce changes only, so a repeated text differs by a blank.
  notice.value = notice.value === keyed ? `${keyed}\u00a0` : keyed;
}

function chosen(actor: Actor, joints: readonly number[]): Chosen {
  const { unkeyed, character } = actor;
  const { skeleton } = character;
  if (unkeyed) return { ...unkeyed, name: nameOf(actor, unkeyed) };
  if (joints.length > 0) {
    const values = joints.flatMap((joint) => freeValues(skeleton, joint));
    const pins = actor.pins.filter(({ joint }) => joints.includes(joint));
    const what = { values, morphs: [], pins: pins.map(({ joint }) => joint) };
    return { ...what, name: namesOf(joints.map((joint) => skeleton.names[joint]!)) };
  }
  const clip = boundClip(actor);
  const shaped = clip && animatedBy(clip, character).morphs;
  return {
    values: skeleton.names.flatMap((_, joint) => freeValues(skeleton, joint)),
    morphs: [...actor.morphWeights.keys()].filter(
      (morph) => actor.morphWeights[morph] !== 0 || shaped?.has(morph),
    ),
    pins: actor.pins.map(({ joint }) => joint),
    name: 'the whole pose',
  };
}

/** The indices of q of a joint, without those that are locked. */
function freeValues({ qMin, qMax, ...skeleton }: Skeleton, joint: number): readonly number[] {
  const [from, to] = jointRange({ qMin, qMax, ...skeleton }, joint);
  return Array.from({ length: to - from }, (_, at) => from + at).filter(
    (index) => qMin[index] !== qMax[index],
  );
}

function nameOf({ character }: Actor, { values, morphs, pins }: KeyedThings): string {
  const { skeleton } = character;
  const joints = values.map((index) => jointOfValue(skeleton, index));
  return namesOf([
    ...new Set([...joints, ...pins].map((joint) => skeleton.names[joint]!)),
    ...morphs.map((morph) => character.morphs[morph]!.name),
  ]);
}

function namesOf([first, ...others]: readonly string[]): string {
  const more = others.length === 0 ? '' : ` and ${others.length} more`;
  return `${printable(first ?? '', 40)}${more}`;
}
