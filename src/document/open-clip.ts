import type { ClipParts } from '../core/motion/clip-parts.ts';
import type { Pin } from '../posing/pins/pin.ts';
import { freeName } from './clip-edits.ts';
import { type Edit, editActor } from './edit.ts';
import type { Actor } from './scene.ts';

/** A pin that a clip moves and that its character does not have yet. */
export type NewPin = Pick<Pin, 'joint' | 'place' | 'weight'>;

/** Gives a character one more clip, which is bound, with the pins that it moves. */
export function openClip({ id }: Actor, clip: ClipParts, pins: readonly NewPin[]): Edit {
  return editActor(id, `Open the motion ${clip.name}`, (actor) => ({
    ...actor,
    clips: [...actor.clips, { ...clip, name: freeName(actor.clips, clip.name) }],
    clip: actor.clips.length,
    unkeyed: null,
    pins: pins.length > 0 ? [...actor.pins, ...pins.map(pinOf)] : actor.pins,
  }));
}

/** A pin at the joint's origin that lets it turn. */
export function pinOf({ joint, place, weight }: NewPin): Pin {
  return { joint, point: [0, 0, 0], place, rotation: null, weight, follows: null };
}
