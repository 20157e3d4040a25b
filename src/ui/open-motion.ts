import { batch } from '@preact/signals-core';
import { type Diagnostic, printable } from '../core/diagnostics.ts';
import { openClip } from '../document/open-clip.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import { extensionOf } from '../formats/file-entry.ts';
import { pinsToMake } from '../formats/motion/pins-to-make.ts';
import { readBoundMotion } from '../formats/motion/read-bound-motion.ts';

interface Scene {
  readonly store: Store;
  readonly session: Session;
}

/**
 * Opens a motion as a clip of the selected character, and shows its start. It is one step of undo.
 *
 * @param file ends in `.anim`, or is read as a MOTION.json
 * @param problems what could not be used is added to it
 * @returns what came of it, for the status line
 */
export function openMotion(
  { store, session }: Scene,
  file: string,
  bytes: Uint8Array,
  problems: Diagnostic[],
): string {
  const actor = selectedActor(store, session);
  if (!actor || actor.character.skeleton.jointCount === 0) {
    return 'There is no character with joints to move';
  }
  const { value: clip, diagnostics, pinPlaces } = readBoundMotion(file, bytes, actor.character);
  problems.push(...diagnostics);
  if (!clip || (clip.channels.length === 0 && clip.unread !== undefined)) {
    return 'The motion was not opened; Problems says why';
  }
  const needed = 3 * actor.character.skeleton.jointCount + 3;
  if (extensionOf(file) === '.anim' && clip.channels.length !== needed) {
    return `The motion was not opened: it has ${clip.channels.length} channels, not ${needed} as for ${printable(actor.name, 40)}`;
  }
  const pinned = actor.pins.map(({ joint }) => joint);
  const { pins, diagnostics: ofPins } = pinsToMake(clip, actor.character, pinned, pinPlaces);
  problems.push(...ofPins);
  batch(() => {
    session.playing.value = false;
    store.dispatch(openClip(actor, clip, pins));
    session.clipIndex.value = actor.clips.length;
    session.clipTime.value = clip.start;
  });
  const count = clip.channels.length;
  const channels = `${count} ${count === 1 ? 'channel' : 'channels'}`;
  const length = Number((clip.end - clip.start).toPrecision(3));
  const remark = diagnostics.length + ofPins.length > 0 ? '; Problems says what was not used' : '';
  return `Motion ${printable(clip.name, 40)} opened: ${channels}, ${length} s${remark}`;
}

/** Whether a JSON text describes a motion, by which of the names of its forms comes first in it. */
export function isMotionText(text: string): boolean {
  return /"(channels|joints|actors)"\s*:/.exec(text)?.[1] === 'channels';
}
