import type { MethodParameter } from '../skinning/method.ts';
import { type Edit, editActor } from './edit.ts';
import type { ActorId } from './scene.ts';

/** Sets a parameter of a skinning method, within its range; a parameter of whole numbers is rounded. */
export function setMethodSetting(id: ActorId, parameter: MethodParameter, value: number): Edit {
  const { name, label, least, most, step } = parameter;
  const allowed = step >= 1 ? Math.round(value) : value;
  const set = Math.min(most, Math.max(least, allowed));
  return editActor(id, `Change “${label}”`, (actor) => ({
    ...actor,
    methodSettings: { ...actor.methodSettings, [name]: set },
  }));
}
