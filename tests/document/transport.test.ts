import { describe, expect, it } from 'vitest';
import { clipFor } from '../../src/core/motion/clip.ts';
import { setPose } from '../../src/document/edits.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { selectedActor } from '../../src/document/selected-actor.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Transport } from '../../src/document/transport.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { holdEdits } from '../../src/evaluation/hold-edits.ts';
import { shownState } from '../../src/evaluation/shown-state.ts';
import { readOne } from '../support/files.ts';
import { allThere } from '../support/kernels.ts';

const skel = 'balljoint hip { balljoint knee { offset 0 1 0 rotxlimit -2 0 } }';
const anim = `animation { range 0 2 numchannels 9
  ${'channel { extrapolate constant constant keys 1 { 0 0 linear linear } }'.repeat(6)}
  channel { extrapolate constant constant keys 2 { 0 0 linear linear 2 -1 linear linear } }
  ${'channel { extrapolate constant constant keys 1 { 0 0 linear linear } }'.repeat(2)} }`;

async function open(files: Record<string, string>) {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  const told: string[] = [];
  const transport = new Transport(store, session, (message) => told.push(message));
  store.dispatch(
    openCharacter(session.selectedActorId.value, await readOne(files), 'linear-blend'),
  );
  const { skeleton } = selectedActor(store, session)!.character;
  const kneeX = skeleton.dofQ[skeleton.dofStart[2]! - 1]!;
  const evaluations = new Evaluations(store, session, allThere);
  holdEdits(store, session, evaluations);
  const shownKnee = (): number => evaluations.selected()!.pose.q[kneeX]!;
  const shown = () => shownState(evaluations.selected()!);
  return { store, session, transport, told, shownKnee, shownState: shown };
}

describe('the transport', () => {
  const files = { 'leg.skel': skel, 'leg.anim': anim };

  it('binds the clip at Play, and shows its values as time passes', async () => {
    const { session, transport, shownKnee } = await open(files);
    expect(transport.isBound).toBe(false);
    transport.togglePlay();
    expect(transport.isBound).toBe(true);
    expect(session.playing.value).toBe(true);
    transport.pass(0.5);
    expect(shownKnee()).toBeCloseTo(-0.25, 12);
    session.playSpeed.value = 2;
    transport.pass(0.5);
    expect(session.clipTime.value).toBeCloseTo(1.5, 12);
    expect(shownKnee()).toBeCloseTo(-0.75, 12);
  });

  it('pauses where it is, and goes on from there', async () => {
    const { session, transport } = await open(files);
    transport.togglePlay();
    transport.pass(0.5);
    transport.togglePlay();
    expect(session.playing.value).toBe(false);
    transport.togglePlay();
    expect(session.clipTime.value).toBe(0.5);
  });

  it('begins again after a clip that was played once has ended', async () => {
    const { session, transport } = await open(files);
    session.playMode.value = 'once';
    transport.togglePlay();
    transport.pass(5);
    expect([session.playing.value, session.clipTime.value]).toEqual([false, 2]);
    transport.togglePlay();
    expect([session.playing.value, session.clipTime.value]).toEqual([true, 0]);
  });

  it('seeks and steps, paused', async () => {
    const { session, transport, shownKnee } = await open(files);
    transport.seek(1);
    expect(shownKnee()).toBeCloseTo(-0.5, 12);
    transport.step(-1);
    expect(session.clipTime.value).toBeCloseTo(1 - 1 / 30, 12);
    transport.seek(2);
    transport.step(1);
    expect(session.clipTime.value).toBe(2);
    expect(session.playing.value).toBe(false);
  });

  it('makes nothing, so that none of it is a step of undo', async () => {
    const { store, session, transport } = await open(files);
    store.dispatch(
      setPose(session.selectedActorId.value!, selectedActor(store, session)!.q, 'None'),
    );
    transport.togglePlay();
    transport.seek(1);
    transport.choose(0);
    expect(store.undoLabel.value).toBeNull();
  });

  it('releases the character in the pose that it shows, as one step of undo', async () => {
    const { store, transport, shownState, shownKnee } = await open(files);
    transport.seek(2);
    transport.release(shownState());
    expect([shownKnee(), transport.isBound]).toEqual([-1, false]);
    store.undo();
    expect([shownKnee(), transport.isBound]).toEqual([-1, true]);
    expect(store.undoLabel.value).toBeNull();
  });

  it('shows an edit over the clip, and undo takes it away', async () => {
    const { store, session, transport, shownKnee } = await open(files);
    transport.seek(2);
    const { id, q } = selectedActor(store, session)!;
    store.dispatch(setPose(id, q));
    expect([shownKnee(), transport.isBound]).toEqual([0, true]);
    store.undo();
    expect([shownKnee(), transport.isBound]).toEqual([-1, true]);
    expect(store.undoLabel.value).toBeNull();
  });

  it('pauses for an edit, at its moment', async () => {
    const { store, session, transport } = await open(files);
    transport.togglePlay();
    transport.pass(0.5);
    const { id, q } = selectedActor(store, session)!;
    store.dispatch(setPose(id, q));
    expect([session.playing.value, session.clipTime.value]).toEqual([false, 0.5]);
  });

  it('drops what is unkeyed when it leaves the moment, and undo brings it back with its time', async () => {
    const { store, session, transport, told, shownKnee } = await open(files);
    transport.seek(1);
    const { id, q } = selectedActor(store, session)!;
    store.dispatch(setPose(id, q, 'Turn'));
    const held = store.scene.value;
    transport.seek(1);
    expect(store.scene.value, 'at the same time nothing is left').toBe(held);
    transport.seek(1.5);
    expect(shownKnee()).toBeCloseTo(-0.75, 12);
    expect(told).toEqual(['1 unkeyed value dropped; Undo brings it back']);
    expect(store.undoLabel.value).toBe('Drop unkeyed values');
    store.undo();
    expect(store.scene.value).toBe(held);
    expect([session.clipTime.value, shownKnee()]).toEqual([1, 0]);
    transport.togglePlay();
    expect([shownKnee(), session.playing.value]).toEqual([-0.5, true]);
    expect(store.undoLabel.value).toBe('Drop unkeyed values');
  });

  it('shows times between the ends of clips, at frames if times snap', async () => {
    const { session, transport } = await open(files);
    transport.seek(7);
    expect(session.clipTime.value).toBe(2);
    transport.seek(0.51);
    expect(session.clipTime.value).toBe(0.5);
    session.snapsToFrames.value = false;
    transport.seek(0.51);
    expect(session.clipTime.value).toBe(0.51);
    session.snapsToFrames.value = true;
    transport.step(1);
    expect(session.clipTime.value).toBeCloseTo(16 / 30, 12);
    session.playMode.value = 'go on';
    transport.seek(7);
    expect(session.clipTime.value).toBe(7);
  });

  it('plays the work range', async () => {
    const { session, transport } = await open(files);
    session.workRange.value = [0.5, 1];
    transport.togglePlay();
    expect(session.clipTime.value).toBe(0.5);
    transport.pass(0.6);
    expect(session.clipTime.value).toBeCloseTo(0.6, 12);
    session.workRange.value = [5, 6];
    transport.pass(1.5);
    expect(session.clipTime.value, 'a range beside the clip is without effect').toBeCloseTo(
      0.1,
      12,
    );
  });

  it('plays all characters together, each its own clip, as long as the longest', async () => {
    const { store, session, transport } = await open(files);
    const long = await readOne({
      'leg.skel': skel,
      'long.anim': anim.replace('range 0 2', 'range 0 5'),
    });
    store.dispatch(openCharacter(null, long, 'linear-blend'));
    store.dispatch(openCharacter(null, await readOne({ 'leg.skel': skel }), 'linear-blend'));
    transport.playAll();
    expect(store.scene.value.actors.map(({ clip }) => clip)).toEqual([0, 0, null]);
    transport.pass(4.5);
    expect(session.clipTime.value).toBe(4.5);
    expect(transport.clip, 'the selected character has none').toBeUndefined();
    transport.togglePlay();
    expect(session.playing.value).toBe(false);
  });

  it('has a clip of the character that undo brings back, whichever was chosen of another', async () => {
    const { store, session, transport } = await open(files);
    const two = await readOne({ ...files, 'leg_two.anim': anim.replace('range 0 2', 'range 1 2') });
    store.dispatch(openCharacter(session.selectedActorId.value, two, 'linear-blend'));
    transport.choose(1);
    expect(transport.clip).toBe(clipFor(two.clips[1]!, two));
    store.undo();
    expect(transport.clip?.end).toBe(2);
    transport.togglePlay();
    expect([transport.isBound, session.playing.value]).toEqual([true, true]);
  });

  it('does nothing for a character without clips', async () => {
    const { store, session, transport } = await open({ 'leg.skel': skel });
    const before = store.scene.value;
    transport.togglePlay();
    transport.seek(1);
    transport.step(1);
    expect(transport.clip).toBeUndefined();
    expect(session.playing.value).toBe(false);
    expect(store.scene.value).toBe(before);
  });
});
