import type { ClipParts } from '../../core/motion/clip-parts.ts';
import { isRotationChannel } from '../../core/motion/clip-parts.ts';
import { insertKey } from '../../core/motion/edit/insert-key.ts';
import { squadTurnOnInsert } from '../../core/motion/edit/squad-turn.ts';
import { channelKey } from '../../core/motion/targets.ts';
import { editClip } from '../../document/clip-edits.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { turnsJoint } from '../../posing/charts/joint-motion.ts';
import { timeInClip } from '../../posing/playhead.ts';
import type { LabEditor } from './rotation-lab.ts';
import { degreesText } from './store-as.ts';
import { type Subject, subjectOf } from './subject.ts';

/** Inserts a key of the selected joint's rotation at the playhead, as one step of undo. */
export function insertRotationKey({ store, session, transport, notice }: LabEditor): void {
  const actor = selectedActor(store, session);
  const subject = subjectOf(actor, transport.clipIndex, session.selectedJoint.value);
  if (typeof subject === 'string') {
    notice.value = subject;
    return;
  }
  const { clip, index, name } = subject;
  const time = timeInClip(clip, session.clipTime.value, session.playMode.value);
  const inserted = withKey(subject, time);
  const at = `${time.toFixed(2)} s`;
  if (inserted === clip) {
    notice.value = `There is a key of ${name} at ${at} already, or its curve repeats there`;
    return;
  }
  notice.value = `Key of ${name} at ${at}; inserting it ${insertText(subject, time)}`;
  store.dispatch(editClip(subject.actor.id, index, `Insert key of ${name}`, () => inserted));
}

/** What a key at a time will do to the joint's motion: "turns the curve by at most 2.31°". */
export function insertText(subject: Subject, time: number): string {
  const turn = Math.max(
    0,
    ...turningChannels(subject).map((channel) =>
      isRotationChannel(channel) ? squadTurnOnInsert(channel, time) : 0,
    ),
  );
  return turn === 0
    ? 'does not change the motion'
    : `turns the curve by at most ${degreesText(turn)}`;
}

/** The clip with a key at a time on every curve that turns the joint; itself if there is none. */
function withKey(subject: Subject, time: number): ClipParts {
  return turningChannels(subject).reduce(
    (clip, { target }) => (target ? insertKey(clip, channelKey(target), time).clip : clip),
    subject.clip,
  );
}

function turningChannels({ clip, actor, joint }: Subject): ClipParts['channels'] {
  const source = actor.character.skeleton.sourceIndex[joint]!;
  return clip.channels.filter((channel) => turnsJoint(channel, source));
}
