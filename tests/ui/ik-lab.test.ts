import { signal } from '@preact/signals-core';
import fc from 'fast-check';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { setPose } from '../../src/document/edits.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { dls } from '../../src/posing/ik/dls.ts';
import type { IkSolver, IkStep } from '../../src/posing/ik/problem.ts';
import { IkLab, type LabEditor, possibleStarts } from '../../src/ui/ik-lab.ts';
import { plotOf } from '../../src/ui/ik-lab-plot.ts';
import {
  conditionText,
  endText,
  flatnessText,
  limitText,
  partText,
} from '../../src/ui/ik-lab-text.ts';
import { readBundled } from '../support/bundled.ts';

/** Takes two steps that do nothing. */
const idle: IkSolver = {
  solve: ({ reference: q }) => ({
    ...{ q: q.slice(), residuals: [1], turns: [0], iterations: 2, status: 'stalled', atLimits: [] },
  }),
  *steps({ reference: q }) {
    const step: IkStep = {
      ...{ q: q.slice(), residuals: [1], text: 'Nothing.', atLimits: [], singularValues: [] },
    };
    yield* [step, step, step];
  },
};

const human = await readBundled('human');
const jointOf = (name: string): number => human.skeleton.names.indexOf(name);

let editor: LabEditor;
let lab: IkLab;

beforeEach(() => {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  store.dispatch(openCharacter(null, human, 'linear-blend'));
  const evaluations = new Evaluations(store, session);
  editor = { store, session, evaluations, notice: signal(''), tab: signal('pose') };
  session.selectedJoint.value = jointOf('Left hand');
  lab = new IkLab(editor, [
    { id: 'dls', label: 'Damped least squares', summary: '', solver: dls },
    { id: 'ccd', label: 'Idle', summary: '', solver: idle },
  ]);
});
afterEach(() => lab.dispose());

const shownQ = (): Float64Array => editor.evaluations.selected()!.poseToEdit.q.slice();
const actor = () => editor.evaluations.selected()!.state;

describe('the IK lab', () => {
  it('has a task for the selected joint, and says why there is none', () => {
    expect(lab.subject.value!.kind).toBe('reachable');
    expect(lab.runs.value.map(({ solution }) => solution.status)).toEqual(['reached', 'stalled']);
    editor.session.selectedJoint.value = jointOf('Root');
    expect(lab.subject.value).toBeNull();
    expect(lab.refusal.value).toMatch(/^Root is a root/);
    expect(lab.runs.value).toEqual([]);
    editor.session.selectedJoint.value = null;
    expect(lab.refusal.value).toMatch(/^Select a joint/);
    editor.session.selectedJoint.value = jointOf('Left foot');
    expect(lab.subject.value!.chain.path.at(-1)).toBe(jointOf('Left foot'));
    editor.store.undo();
    editor.session.selectedActorId.value = null;
    expect(lab.refusal.value).toBe('There is no character.');
  });

  it('goes through the steps of a method, and stops at the ends', () => {
    const last = lab.lastStep.value;
    lab.goTo(-3);
    expect(lab.at.value).toBe(0);
    lab.togglePlay();
    expect(lab.playing.value).toBe(true);
    lab.goTo(last + 9);
    expect([lab.at.value, lab.playing.value]).toEqual([last, false]);
    lab.togglePlay();
    expect([lab.at.value, lab.playing.value]).toEqual([0, true]);
    lab.goTo(last);
    lab.chooseMethod('ccd');
    expect([lab.at.value, lab.playing.value, lab.step.value!.text]).toEqual([2, false, 'Nothing.']);
    lab.aimAt('far');
    expect(lab.at.value).toBe(0);
  });

  it('leaves the scene alone until a step is applied, which is one step of undo', () => {
    const { scene, undoLabel } = editor.store;
    const before = scene.value;
    const q = shownQ();
    for (const kind of ['far', 'close', 'straight', 'reachable'] as const) lab.aimAt(kind);
    lab.goTo(3);
    expect(scene.value).toBe(before);
    lab.apply();
    expect(shownQ()).toEqual(lab.step.value!.q);
    expect(undoLabel.value).toBe('Pose of the IK lab');
    expect(editor.notice.value).toMatch(/step 3 of Damped least squares/);
    // What was shown stays, so that other steps can be applied as well.
    expect([lab.at.value, lab.isPoseNew.value]).toEqual([3, true]);
    expect(lab.subject.value!.q).toEqual(q);
    editor.store.undo();
    expect(scene.value).toBe(before);
    expect(lab.isPoseNew.value).toBe(false);
  });

  it('starts from the pose of the moment when it is asked to', () => {
    const { target } = lab.subject.value!;
    const q = shownQ();
    q[human.skeleton.dofQ[human.skeleton.dofStart[jointOf('Left forearm')]!]!]! -= 0.4;
    editor.store.dispatch(setPose(actor().id, q));
    expect(lab.isPoseNew.value).toBe(true);
    lab.startFromShown();
    expect(lab.isPoseNew.value).toBe(false);
    expect(lab.subject.value!.target).toEqual(target);
    expect(lab.run.value!.steps[0]!.q).toEqual(q);
    lab.moveTarget([0.1, 0.9, 0.2]);
    expect(lab.subject.value!.kind).toBeNull();
    expect(lab.subject.value!.target).toEqual([0.1, 0.9, 0.2]);
    editor.store.dispatch(setPose(actor().id, human.skeleton.qRest));
    expect(lab.run.value!.steps[0]!.q, 'as long as it is not asked').toEqual(q);
  });

  it('takes a chain from any joint above', () => {
    const starts = possibleStarts(lab.subject.value!.chain);
    expect(starts[0]).toBe(jointOf('Left forearm'));
    expect(starts.at(-1)).toBe(jointOf('Root'));
    lab.aimAt('reachable', jointOf('Left forearm'));
    expect(lab.subject.value!.chain.moving).toEqual([jointOf('Left forearm')]);
    lab.aimAt('far');
    expect(lab.subject.value!.chain.path).toHaveLength(2);
  });

  it('draws the chain, the steps before and the target in the pose tab alone, until it is closed', () => {
    const { ikSketch } = editor.session;
    lab.goTo(4);
    const { chain, target } = lab.subject.value!;
    const shown = ikSketch.value!;
    expect(shown.chain).toHaveLength(chain.path.length);
    expect(shown.earlier).toHaveLength(4);
    expect(shown.target).toBe(target);
    editor.tab.value = 'deform';
    expect(ikSketch.value).toBeNull();
    editor.tab.value = 'pose';
    expect(ikSketch.value).not.toBeNull();
    editor.session.selectedJoint.value = null;
    expect(ikSketch.value).toBeNull();
    editor.session.selectedJoint.value = jointOf('Left hand');
    lab.dispose();
    expect(ikSketch.value).toBeNull();
  });

  it('keeps to how the joints move by nature as the character does, or as chosen', () => {
    const solved = (): Float64Array => lab.run.value!.solution.q;
    const natural = solved();
    expect(lab.natures.value.map(({ joint }) => joint)).toContain(jointOf('Left forearm'));
    expect(lab.isNatural.value).toBe(true);
    lab.setNatural(false);
    expect(solved()).not.toEqual(natural);
    expect(actor().natures.isOn).toBe(true);
    lab.setNatural(true);
    expect(solved()).toEqual(natural);
  });
});

describe('the texts of the IK lab', () => {
  it('say residuals and condition numbers with few digits', () => {
    expect([0, 1, 0.123456, 0.00012, 1e-9].map(partText)).toEqual([
      ...['0 %', '100 %', '12 %', '0.012 %', 'under 0.0001 %'],
    ]);
    expect([1, 12.345, 1e7, Infinity].map(conditionText)).toEqual([
      ...['1', '12.3', 'over 1000', 'over 1000'],
    ]);
    const [run] = lab.runs.value;
    expect(endText(run!)).toMatch(/^reached it after \d+ steps, with \S+ % left\.$/);
    lab.aimAt('far');
    expect(endText(lab.runs.value[0]!)).toMatch(/^found it out of reach after/);
  });

  it('say that a straight limb can hardly be shortened by small turns', () => {
    const { chain, q } = lab.subject.value!;
    expect(flatnessText(chain, q, lab.ellipsoid.value)).toBe('');
    lab.aimAt('straight');
    expect(flatnessText(chain, lab.step.value!.q, lab.ellipsoid.value)).toBe(
      'The limb is almost straight: no small turn brings Left hand nearer along it.',
    );
    lab.aimAt('reachable', jointOf('Left forearm'));
    const forearm = lab.subject.value!.chain;
    expect(flatnessText(forearm, q, lab.ellipsoid.value)).toMatch(/straight|one plane/);
  });

  it('name a limit, and which of both it is', () => {
    const { skeleton } = human;
    const joint = jointOf('Left forearm');
    const index = skeleton.dofQ[skeleton.dofStart[joint]!]!;
    const limited = {
      ...skeleton,
      qMin: skeleton.qMin.map((value, i) => (i === index ? -1 : value)),
      qMax: skeleton.qMax.map((value, i) => (i === index ? Math.PI / 2 : value)),
    };
    const at = (value: number): string =>
      limitText(
        limited,
        skeleton.qRest.map((rest, i) => (i === index ? value : rest)),
        index,
      );
    expect(at(-1)).toBe('Left forearm X is at its lower limit, -57.3°.');
    expect(at(Math.PI / 2)).toBe('Left forearm X is at its upper limit, 90°.');
  });
});

describe('the plot of residuals', () => {
  const inside = fc.double({ min: 1e-9, max: 3, noNaN: true });

  it('has later steps to the right and greater residuals above, within its area', () => {
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 200 }), inside, inside, inside, (last, top, a, b) => {
        const { across, down, area, steps } = plotOf(last, Math.max(top, a, b));
        expect(across(0)).toBe(area.left);
        expect(across(Math.max(1, last))).toBeCloseTo(area.right, 9);
        for (let i = 1; i <= last; i++) expect(across(i)).toBeGreaterThan(across(i - 1));
        if (a < b) expect(down(a)).toBeGreaterThanOrEqual(down(b));
        for (const part of [a, b]) {
          expect(down(part)).toBeGreaterThanOrEqual(area.top - 1e-9);
          expect(down(part)).toBeLessThanOrEqual(area.bottom + 1e-9);
        }
        steps.slice(1).forEach((step, i) => {
          expect(across(step) - across(steps[i]!)).toBeGreaterThanOrEqual(22);
        });
      }),
    );
  });
});
