import { bindClip } from '../../src/document/edits.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { holdEdits } from '../../src/evaluation/hold-edits.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';
import { swingOf } from '../fixtures/swing.ts';
import { allThere } from './kernels.ts';

/** A scene of one actor whose clip is bound, where edits are held over the clip. */
export function openSwinging() {
  const store = new Store();
  const session = new Session();
  const evaluations = new Evaluations(store, session, allThere);
  holdEdits(store, session, evaluations);
  const made = characterOfRig(rotatedTree());
  const character = { ...made, clips: [swingOf(made)] };
  store.dispatch(openCharacter(null, character, 'linear-blend'));
  const actor = () => store.scene.value.actors[0]!;
  store.dispatch(bindClip(actor().id, 0));
  return { store, session, evaluations, actor };
}
