import type { Actor } from '../../src/document/scene.ts';
import { signal } from '@preact/signals-core';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { setInfluencesOf } from '../../src/document/skin-edits.ts';
import { setInfluences } from '../../src/document/weight-edits.ts';
import { editActor } from '../../src/document/edit.ts';
import { bindClip } from '../../src/document/edits.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { Session } from '../../src/document/session.ts';
import { addSavedPose } from '../../src/document/saved-poses.ts';
import { addShot } from '../../src/document/shots.ts';
import { Store } from '../../src/document/store.ts';
import { comparisonOf } from '../../src/document/comparison.ts';
import { cuttingSettings } from '../../src/ui/deform-lab/cutting-settings.ts';
import { showsStressSheet } from '../../src/ui/deform-lab/measures-open.ts';
import type { Figure } from '../../src/ui/deform-lab/figure-paths.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { Transport } from '../../src/document/transport.ts';
import { workspaces } from '../../src/app/workspaces.ts';
import { commands } from '../../src/ui/commands/registry.ts';
import type { Editor, Progress } from '../../src/ui/editor.ts';
import { paletteEntries } from '../../src/ui/palette-entries.ts';
import { type Findable, fitsQuery, rankEntries } from '../../src/ui/rank-entries.ts';
import { startCamera } from '../../src/view/camera.ts';
import { leg } from '../support/cse169-files.ts';
import { readOne } from '../support/files.ts';
import { copyKeys } from '../../src/core/motion/edit/copy-keys.ts';
import { channelKey } from '../../src/core/motion/targets.ts';
import { copiedKeys } from '../../src/ui/timeline/timeline-state.ts';
import { selectedActor } from '../../src/document/selected-actor.ts';

const progress = signal<Progress | null>(null);

/** An editor with a character that has a clip, whose names and joints are many and awkward. */
async function createEditor(): Promise<Editor> {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  store.dispatch(openCharacter(null, await readOne(leg), 'linear-blend'));
  store.dispatch(openCharacter(null, await readOne(leg), 'linear-blend'));
  const names = ['Reset', 'Open', 'Add', 'Select', 'Walk', 'Orbit'];
  const parts = {
    store,
    session,
    transport: new Transport(store, session),
    workspaces,
    bundled: signal(
      names.flatMap((name) => [1, 2].map((n) => ({ id: `${name}${n}`, label: name }))),
    ),
    scenes: [{ id: 'meeting', label: 'Address of two' }],
    dialog: signal('palette'),
    showsRotationLab: signal(false),
    progress,
    viewer: { camera: signal(startCamera) },
    evaluations: new Evaluations(store, session),
  };
  return parts as unknown as Editor;
}

const editor = await createEditor();

const finds = (entries: readonly Findable[], typed: string, recent: readonly string[] = []) =>
  rankEntries(entries, typed, recent).map(({ label }) => label);

function entriesOf(...labels: readonly string[]): Findable[] {
  return labels.map((label, index) => ({ id: `${index}`, label, isCommand: true }));
}

function withPin(actor: Actor): Actor {
  const [point, place] = [[0, 0, 0] as const, [0, 1, 0] as const];
  const pin = { joint: 0, point, place, rotation: null, weight: 1, follows: null };
  return { ...actor, pins: [pin] };
}

function withNature(actor: Actor): Actor {
  const range = [-1, 1] as const;
  const own = { joint: 0, stiffness: 2, bend: range, side: range, twist: range };
  return { ...actor, natures: { isOn: true, own: [own] } };
}

describe('the palette', () => {
  it('has each command among its first eight after the first two letters of its name', () => {
    const { session, store } = editor;
    const entries = paletteEntries(editor);
    const listed = entries.filter(({ isCommand }) => isCommand);
    expect(listed.length).toBeGreaterThan(30);
    const ids = entries.map(({ id }) => id);
    expect(new Set(ids).size).toBe(ids.length);
    fc.assert(
      fc.property(
        fc.constantFrom(...listed),
        fc.shuffledSubarray(ids),
        fc.boolean(),
        ({ id, label }, recent, upper) => {
          const two = label.slice(0, 2);
          const found = rankEntries(entries, upper ? two.toUpperCase() : two.toLowerCase(), recent);
          expect(found.slice(0, 8).map((each) => each.id)).toContain(id);
        },
      ),
      { numRuns: 500 },
    );
    expect(store.scene.value.actors).toHaveLength(2);
    expect(session.selectedActorId.value).not.toBeNull();
  });

  it('lists every command that does something now, and no other', () => {
    const { session, store } = editor;
    const listed = () => paletteEntries(editor).map(({ id }) => id);
    const fitting = commands.filter(({ keyOnly }) => !keyOnly).map(({ id }) => id);
    expect(listed()).not.toContain('palette');
    expect(listed()).toContain('undo');
    expect(listed()).not.toContain('redo');
    store.undo();
    expect(listed()).toContain('redo');
    expect(listed()).not.toContain('undo');
    expect(listed()).not.toContain('reset-joint');
    session.selectedJoint.value = 0;
    expect(listed()).toContain('reset-joint');
    // What is done to the whole character may deselect its joint.
    expect(listed()).toContain('move-tool');
    expect(listed()).not.toContain('place-axes');
    expect(listed()).not.toContain('unpin-all');
    store.amend(editActor(session.selectedActorId.value!, 'Pin', withPin));
    expect(listed()).toContain('unpin-all');
    expect(listed()).not.toContain('reset-nature');
    store.amend(editActor(session.selectedActorId.value!, 'Own', withNature));
    expect(listed()).toContain('reset-nature');
    expect(listed()).not.toContain('release-clip');
    store.amend(bindClip(session.selectedActorId.value!, 0));
    expect(listed()).toContain('release-clip');
    expect(listed()).not.toContain('whole-range');
    session.workRange.value = [0, 0.5];
    expect(listed()).toContain('whole-range');
    expect(listed()).not.toContain('worst-vertex');
    store.amend(setInfluences(session.selectedActorId.value!, 2));
    expect(listed()).toContain('worst-vertex');
    expect(listed()).not.toContain('walk-ahead');
    session.firstPerson.value = true;
    expect(listed()).toContain('walk-ahead');
    // Each is listed in one of the states above.
    const seen = new Set(listed());
    session.firstPerson.value = false;
    session.boneMode.value = true;
    session.ikMode.value = true;
    progress.value = { label: 'Reading', fraction: 0 };
    store.redo();
    expect(listed()).not.toContain('update-shot');
    const moved = { ...startCamera, azimuth: 1 };
    store.dispatch(addShot({ id: 1, name: 'Shot 1', camera: moved, aspect: '4:5' }));
    session.shownShot.value = 1;
    for (const id of listed()) seen.add(id);
    session.selectedJoint.value = null;
    session.placeTool.value = 'move';
    for (const id of listed()) seen.add(id);
    // The second of three poses of the library can be moved either way.
    expect(listed()).not.toContain('pose-earlier');
    for (const id of [1, 2, 3]) {
      const pose = { id, name: `Pose ${id}`, height: 0, joints: [], morphs: [] };
      store.dispatch(addSavedPose(pose));
    }
    session.chosenPose.value = 'saved 2';
    for (const id of listed()) seen.add(id);
    // Keys are selected in a timeline that shows curves, and some were copied.
    session.timelineView.value = 'curves';
    const { clip, clips } = selectedActor(store, session)!;
    const keys = new Map([[channelKey(clips[clip ?? 0]!.channels[0]!.target!), [0]]]);
    session.selectedKeys.value = keys;
    copiedKeys.value = copyKeys(clips[clip ?? 0]!, keys);
    for (const id of listed()) seen.add(id);
    // Two methods are compared, a plane cuts the character, and the stress suite has run.
    showsStressSheet.value = true;
    session.comparison.value = comparisonOf(['linear-blend', 'rigid']);
    cuttingSettings(session).figure.value = {} as Figure;
    for (const id of listed()) seen.add(id);
    expect(listed()).not.toContain('normalize-vertex');
    expect(listed()).not.toContain('reset-weights');
    const { id: actorId } = selectedActor(store, session)!;
    const row = [{ entry: 0, weight: 0.5 }];
    store.dispatch(setInfluencesOf(actorId, new Map([[0, row]]), 'Weights'));
    session.inspectedPoint.value = 0;
    for (const id of listed()) seen.add(id);
    const never = fitting.filter((id) => !seen.has(id));
    expect(never).toEqual(['palette']);
  });

  it('has rows for looks, methods, characters, scenes and joints', () => {
    const labels = paletteEntries(editor).map(({ label }) => label);
    expect(labels).toEqual(
      expect.arrayContaining([
        ...['6.837 look', 'Method: Rigid parts', 'Add Walk', 'Open Address of two', 'Select knee'],
      ]),
    );
  });
});

describe('how curves go on, by the palette', () => {
  it('is a rule of the curves with selected keys at one end, in one step', async () => {
    const own = await createEditor();
    const { store, session } = own;
    store.dispatch(bindClip(selectedActor(store, session)!.id, 0));
    const rows = () => paletteEntries(own).filter(({ id }) => id.startsWith('continue '));
    expect(rows()).toEqual([]);
    const clip = () => selectedActor(store, session)!.clips[0]!;
    const before = store.scene.value;
    session.selectedKeys.value = new Map(
      [1, 2].map((at) => [
        channelKey(clip().channels[at]!.target!),
        [clip().channels[at]!.keys[0]!.time],
      ]),
    );
    expect(rows().map(({ label }) => label)).toHaveLength(10);
    rows()
      .find(({ label }) => label === 'Continue the curves after their keys: cycle with offset')!
      .run();
    expect(
      clip()
        .channels.slice(0, 4)
        .map((each) => [each.before, each.after]),
    ).toEqual([
      ['constant', 'linear'],
      ['cycle', 'cycle_offset'],
      ['bounce', 'cycle_offset'],
      ['linear', 'constant'],
    ]);
    store.undo();
    expect(store.scene.value).toBe(before);
  });
});

describe('ranking', () => {
  it('prefers starts of labels, then starts of words, then parts, then letters in order', () => {
    const labels = ['aski.n', 'Reskin', 'Skewed inn', 'Show the skin', 'Skin', 'Bones'];
    expect(finds(entriesOf(...labels), 'skin')).toEqual([
      'Skin',
      'Show the skin',
      'Skewed inn',
      'Reskin',
      'aski.n',
    ]);
  });

  it('finds words by their starts, in order', () => {
    const entries = entriesOf('Select left elbow', 'Select elbow left', 'Select_right_elbow');
    expect(finds(entries, ' le  el')[0]).toBe('Select left elbow');
    expect(finds(entries, 'leel')[0]).toBe('Select left elbow');
    expect(finds(entries, 'ri ELB')).toEqual(['Select_right_elbow']);
  });

  it('prefers what was used lately, and short labels, among equals', () => {
    const entries = entriesOf('Open a folder', 'Open a pose', 'Open files');
    expect(finds(entries, 'op')).toEqual(['Open files', 'Open a pose', 'Open a folder']);
    expect(finds(entries, 'op', ['0', '1'])).toEqual([
      'Open a folder',
      'Open a pose',
      'Open files',
    ]);
  });

  it('finds a label by any of its letters that are in order, and by no others', () => {
    const label = fc.string({ minLength: 1 }).filter((text) => text.trim() !== '');
    fc.assert(
      fc.property(label, fc.array(fc.nat()), fc.string(), (text, picks, other) => {
        const places = [...new Set(picks.map((pick) => pick % text.length))].sort((a, b) => a - b);
        const letters = places.map((place) => text[place]!).join('');
        expect(finds(entriesOf(text), letters)).toEqual([text]);
        const strange = Array.from(other).some(
          (letter) => letter !== ' ' && !text.includes(letter),
        );
        const isPlain = /^[a-z ]*$/.test(text + other) && other.trim() === other;
        if (isPlain && strange) expect(finds(entriesOf(text), other)).toEqual([]);
      }),
    );
  });

  it('filters a gallery by parts of names, not by scattered letters', () => {
    expect(fitsQuery('Twisting tube', 'tub')).toBe(true);
    expect(fitsQuery('Twisting tube', 'TW TU')).toBe(true);
    expect(fitsQuery('Twisting tube', 'tgt')).toBe(false);
  });
});
