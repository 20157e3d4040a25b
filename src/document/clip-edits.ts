import { assert } from '../core/assert.ts';
import { type ClipParts, defaultFps } from '../core/motion/clip-parts.ts';
import { type Edit, editActor } from './edit.ts';
import type { ShownState } from './keying-targets.ts';
import type { Actor, ActorId } from './scene.ts';

/** In seconds. */
const newLength = 2;

/** Changes one of an actor's clips. */
export function editClip(
  id: ActorId,
  index: number,
  label: string,
  edit: (clip: ClipParts) => ClipParts,
): Edit {
  return editActor(id, label, (actor) => {
    const clip = actor.clips[index];
    assert(clip !== undefined, 'a clip of the character');
    const edited = edit(clip);
    return edited === clip ? actor : { ...actor, clips: actor.clips.with(index, edited) };
  });
}

/** A clip without curves, whose name none of the others has. */
export function emptyClip(others: readonly ClipParts[]): ClipParts {
  const name = freeName(others, 'Motion');
  return { file: '', name, start: 0, end: newLength, fps: defaultFps, channels: [] };
}

/** Makes an empty clip and binds it; what is shown becomes the character's own. */
export function addClip({ id }: Actor, shown: ShownState): Edit {
  return editActor(id, 'New clip', (actor) => ({
    ...withShown(actor, shown),
    clips: [...actor.clips, emptyClip(actor.clips)],
    clip: actor.clips.length,
  }));
}

/** Copies a clip to the end of the list; where the original is bound, the copy takes its place. */
export function duplicateClip({ id, clips }: Actor, index: number): Edit {
  const { name } = clips[index]!;
  return editActor(id, `Duplicate ${name}`, (actor) => {
    const copy = { ...actor.clips[index]!, name: freeName(actor.clips, name) };
    const clip = actor.clip === index ? actor.clips.length : actor.clip;
    return { ...actor, clips: [...actor.clips, copy], clip };
  });
}

/** Removes a clip. If it is bound, what is shown becomes the character's own. */
export function removeClip({ id, clips }: Actor, index: number, shown: ShownState): Edit {
  return editActor(id, `Delete ${clips[index]!.name}`, (actor) => {
    const released = actor.clip === index ? withShown(actor, shown) : actor;
    const after = released.clip !== null && released.clip > index ? released.clip - 1 : null;
    const clip = released.clip !== null && released.clip < index ? released.clip : after;
    return { ...released, clips: actor.clips.toSpliced(index, 1), clip };
  });
}

/** Unbinds the clip; what is shown becomes the character's own. */
export function releaseClip({ id }: Actor, shown: ShownState): Edit {
  return editActor(id, 'Release the clip', (actor) => withShown(actor, shown));
}

export function renameClip({ id, clips }: Actor, index: number, name: string): Edit {
  const label = `Rename ${clips[index]!.name}`;
  return editClip(id, index, label, (clip) => (clip.name === name ? clip : { ...clip, name }));
}

/** Sets the range that is played, in seconds. */
export function setClipRange({ id }: Actor, index: number, start: number, end: number): Edit {
  assert(end > start, 'a range that is not empty');
  return editClip(id, index, 'Set the length of the clip', (clip) =>
    clip.start === start && clip.end === end ? clip : { ...clip, start, end },
  );
}

/** Sets the frames a second; keys stay at their times. */
export function setClipFps({ id }: Actor, index: number, fps: number): Edit {
  assert(fps > 0, 'frames a second');
  return editClip(id, index, `${fps} frames a second`, (clip) =>
    clip.fps === fps ? clip : { ...clip, fps },
  );
}

function withShown(actor: Actor, { q, morphWeights, pins }: ShownState): Actor {
  return { ...actor, q, morphWeights, pins, clip: null, unkeyed: null };
}

/** The name itself, or with the first number that makes it another than the others'. */
export function freeName(others: readonly ClipParts[], name: string): string {
  const taken = new Set(others.map((clip) => clip.name));
  let free = name;
  for (let number = 2; taken.has(free); number++) free = `${name} ${number}`;
  return free;
}
