import { type OwnNature, plainNatures } from '../posing/natural/nature-settings.ts';
import { type Edit, editActor } from './edit.ts';
import type { Actor, ActorId } from './scene.ts';

/** Lets inverse kinematics keep to the natures of a character's joints, or not. */
export function setNatural(id: ActorId, isOn: boolean): Edit {
  const label = isOn ? 'Bend joints as is natural' : 'Bend joints freely';
  return editActor(id, label, (actor) => ({ ...actor, natures: { ...actor.natures, isOn } }));
}

/** Gives a joint a nature of the user's own. */
export function setNature({ id }: Actor, nature: OwnNature, label: string): Edit {
  return editActor(id, label, (actor) => {
    const own = [...othersOf(actor, nature.joint), nature];
    own.sort((a, b) => a.joint - b.joint);
    return { ...actor, natures: { ...actor.natures, own } };
  });
}

/** Gives a joint the nature again that was found. */
export function resetNature({ id, character }: Actor, joint: number): Edit {
  const label = `Reset the nature of ${character.skeleton.names[joint]!}`;
  return editActor(id, label, (actor) => {
    const own = othersOf(actor, joint);
    const isPlain = own.length === 0 && actor.natures.isOn;
    return { ...actor, natures: isPlain ? plainNatures : { ...actor.natures, own } };
  });
}

function othersOf({ natures }: Actor, joint: number): OwnNature[] {
  return natures.own.filter((each) => each.joint !== joint);
}
