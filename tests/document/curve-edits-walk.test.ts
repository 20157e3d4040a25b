import fc from 'fast-check';
import { expect, it } from 'vitest';
import type { ClipParts, Extrapolation, Tangent } from '../../src/core/motion/clip-parts.ts';
import { copyKeys, pasteKeys } from '../../src/core/motion/edit/copy-keys.ts';
import { setExtrapolation } from '../../src/core/motion/edit/extrapolation.ts';
import { insertKey } from '../../src/core/motion/edit/insert-key.ts';
import { moveKeys, scaleKeys } from '../../src/core/motion/edit/move-keys.ts';
import { removeKeys } from '../../src/core/motion/edit/remove-keys.ts';
import { changeKey, setKey } from '../../src/core/motion/edit/set-key.ts';
import { setTangents } from '../../src/core/motion/edit/tangents.ts';
import type { KeySelection } from '../../src/core/motion/key-selection.ts';
import { channelKey } from '../../src/core/motion/targets.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { editClip } from '../../src/document/clip-edits.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { sameScene, type Scene } from '../../src/document/scene.ts';
import { Store } from '../../src/document/store.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';
import { swingOf } from '../fixtures/swing.ts';

const bare = characterOfRig(rotatedTree());
const character = { ...bare, clips: [swingOf(bare)] };

const tangents: readonly Tangent[] = [
  ...(['flat', 'linear', 'smooth', 'auto', 'stepped', -1.25] as const),
  { tcb: [0.2, -0.4, 0.5] },
];
const rules: readonly Extrapolation[] = ['constant', 'linear', 'cycle', 'cycle_offset', 'bounce'];

/** Some keys of a clip, chosen by a number. */
function someKeys({ channels }: ClipParts, number: number): KeySelection {
  const chosen = channels.flatMap(({ target, keys }, index) => {
    const times = keys.map(({ time }) => time).filter((_, at) => (at + index + number) % 3 === 0);
    return target && times.length > 0 ? [[channelKey(target), times] as const] : [];
  });
  return new Map(chosen);
}

const keyOfOne = ({ channels }: ClipParts, number: number): string => {
  const targets = channels.flatMap(({ target }) => target ?? []);
  return targets.length === 0 ? '' : channelKey(targets[number % targets.length]!);
};

const edits: readonly ((clip: ClipParts, number: number) => ClipParts)[] = [
  (clip, n) => moveKeys(clip, someKeys(clip, n), { seconds: (n % 7) / 30, value: 0.1 }).clip,
  (clip, n) =>
    scaleKeys(clip, someKeys(clip, n), {
      aboutTime: 0.5,
      timeFactor: 0.5 + (n % 5) / 4,
      valueFactor: -1 + (n % 3),
    }).clip,
  (clip, n) => setTangents(clip, someKeys(clip, n), 'both', tangents[n % tangents.length]!),
  (clip, n) => setTangents(clip, someKeys(clip, n), n % 2 ? 'in' : 'out', tangents[n % 6]!),
  (clip, n) => insertKey(clip, keyOfOne(clip, n), (n % 61) / 31).clip,
  (clip, n) => setExtrapolation(clip, keyOfOne(clip, n), n % 2 ? 'before' : 'after', rules[n % 5]!),
  (clip, n) =>
    pasteKeys(clip, copyKeys(clip, someKeys(clip, n)), n / 100, { reversed: n % 2 > 0 }).clip,
  (clip, n) => (n % 3 === 0 ? removeKeys(clip, someKeys(clip, n)) : clip),
  (clip, n) => changeKey(clip, keyOfOne(clip, n), 0, { value: n / 500 }).clip,
  (clip, n) => {
    const axis = (n % 3) as 0 | 1 | 2;
    const target = { of: 'value', joint: n % 4, kind: DofKind.hinge, axis } as const;
    return setKey(clip, target, (n % 90) / 30, n / 1000);
  },
];

it('undoes 300 random edits of curves byte for byte, and does them again', () => {
  const store = new Store();
  store.dispatch(openCharacter(null, character, 'linear-blend'));
  const [{ id }] = store.scene.value.actors as [Scene['actors'][0]];
  const scenes: Scene[] = [store.scene.value];
  const used = new Set<number>();
  const walk = fc.sample(fc.tuple(fc.nat(edits.length - 1), fc.nat(1000)), {
    numRuns: 3000,
    seed: 15,
  });
  for (const [edit, number] of walk) {
    if (scenes.length > 300) break;
    store.dispatch(editClip(id, 0, 'Curve', (clip) => edits[edit]!(clip, number)));
    if (store.scene.value === scenes.at(-1)) continue;
    scenes.push(store.scene.value);
    used.add(edit);
  }
  expect(scenes.length).toBe(301);
  expect(used.size, 'every kind of edit').toBe(edits.length);
  const written = scenes.map((scene) => JSON.stringify(scene.actors[0]!.clips));
  for (const [at, scene] of [...scenes.entries()].toReversed()) {
    expect(sameScene(store.scene.value, scene)).toBe(true);
    expect(JSON.stringify(store.scene.value.actors[0]!.clips)).toBe(written[at]);
    store.undo();
  }
  for (let at = 1; at < scenes.length; at++) {
    store.redo();
    expect(JSON.stringify(store.scene.value.actors[0]!.clips)).toBe(written[at]);
  }
});
