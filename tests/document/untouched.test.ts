import { describe, expect, it } from 'vitest';
import { bindClip, removeActor, setPose } from '../../src/document/edits.ts';
import { openCharacter, openCharacters } from '../../src/document/open-characters.ts';
import type { Source } from '../../src/document/scene.ts';
import { Store } from '../../src/document/store.ts';
import { isUntouched } from '../../src/document/untouched.ts';
import { leg } from '../support/cse169-files.ts';
import { readOne } from '../support/files.ts';

const character = await readOne(leg);
const bundled: Source = { kind: 'bundled', id: 'leg' };

function firstScene(...sources: readonly Source[]): Store {
  const store = new Store();
  const actors = sources.map((source) => ({
    character,
    method: 'linear-blend' as const,
    kept: { source },
  }));
  store.dispatch(openCharacters([], actors));
  return store;
}

describe('a scene is untouched', () => {
  it('while it is as the page opened it, with one or several bundled characters', () => {
    expect(isUntouched(new Store())).toBe(true);
    expect(isUntouched(firstScene(bundled))).toBe(true);
    expect(isUntouched(firstScene(bundled, bundled))).toBe(true);
  });

  it('although a clip plays, which is no step of undo', () => {
    const store = firstScene(bundled);
    store.amend(bindClip(1, 0));
    expect(isUntouched(store)).toBe(true);
  });

  it('no longer once files were opened, even as the first thing', () => {
    expect(isUntouched(firstScene({ kind: 'files', files: [] }))).toBe(false);
    expect(isUntouched(firstScene(bundled, { kind: 'files', files: [] }))).toBe(false);
  });

  it('no longer after any edit, even if it is undone, because redo would be lost', () => {
    const q = character.skeleton.qRest.map((value) => value + 0.1);
    const actor = firstScene(bundled).scene.value.actors[0]!;
    const edits = [
      setPose(1, q),
      removeActor(actor),
      openCharacter(null, character, 'linear-blend', { source: bundled }),
      openCharacter(1, character, 'linear-blend', { source: bundled }),
    ];
    for (const edit of edits) {
      const store = firstScene(bundled);
      store.dispatch(edit);
      expect(isUntouched(store), edit.label).toBe(false);
      store.undo();
      expect(isUntouched(store), edit.label).toBe(false);
    }
  });

  it('still after an edit that changes nothing, or a drag that was canceled', () => {
    const store = firstScene(bundled);
    const { q } = store.scene.value.actors[0]!;
    store.dispatch(setPose(1, q));
    const gesture = store.begin('Turn');
    gesture.preview(
      setPose(
        1,
        q.map((value) => value + 1),
      ),
    );
    gesture.cancel();
    expect(isUntouched(store)).toBe(true);
  });
});
