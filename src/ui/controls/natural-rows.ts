import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import { setNature } from '../../document/nature-edits.ts';
import type { Actor } from '../../document/scene.ts';
import { stiffest } from '../../document/scene-json/natures-json.ts';
import type { JointNature } from '../../posing/ik/problem.ts';
import { bodyOf } from '../../posing/natural/body.ts';
import type { OwnNature } from '../../posing/natural/nature-settings.ts';
import { naturesInUse } from '../../posing/natural/natures-in-use.ts';
import { naturesOf } from '../../posing/natural/natures.ts';
import type { Editor } from '../editor.ts';
import { addCommandRow } from './command-row.ts';
import { addNote } from './note.ts';
import { addValueRow, type ValueRow } from './value-row.ts';

type RangeName = 'bend' | 'side' | 'twist';

const ranges: readonly { readonly name: RangeName; readonly label: string }[] = [
  { name: 'bend', label: 'Bend' },
  { name: 'side', label: 'Sideways' },
  { name: 'twist', label: 'Twist' },
];

/**
 * Adds the switch of natural joints, and the selected joint's nature: its stiffness and its soft ranges,
 * with a way back. Returns what ends its effects.
 */
export function addNaturalRows(folder: GUI, editor: Editor): () => void {
  const { session, evaluations } = editor;
  addCommandRow(folder, editor, 'natural-joints');
  let rows: readonly ValueRow[] = [];
  let own: GUI | null = null;
  /** The character, the actor and the joint whose rows there are, and whether natures are on. */
  let shown: readonly unknown[] = [];

  return effect(() => {
    const state = evaluations.selected()?.state;
    const joint = session.selectedJoint.value;
    const next = [state?.character, state?.id ?? null, joint, state?.natures.isOn];
    if (next.some((part, index) => part !== shown[index])) {
      shown = next;
      own?.destroy();
      own = null;
      rows = [];
      if (state && joint !== null && state.natures.isOn) {
        own = folder.addFolder(titleOf(state, joint)).close();
        rows = addRows(own, editor, state, joint);
      }
    }
    for (const row of rows) row.refresh();
  });
}

function titleOf({ character }: Actor, joint: number): string {
  const role = bodyOf(character).roles[joint];
  const name = character.skeleton.names[joint]!;
  return role ? `${name} moves as: ${role}` : `${name} moves freely`;
}

function addRows(folder: GUI, editor: Editor, state: Actor, joint: number): readonly ValueRow[] {
  const { store, evaluations } = editor;
  const known = naturesOf(state.character).find((nature) => nature.joint === joint);
  if (!known) {
    addNote(folder, 'Neither its name nor its place tells how it moves by nature.');
    return [];
  }
  const found: JointNature = known;
  const current = (): Actor => evaluations.selected()?.state ?? state;
  const nature = (): JointNature => {
    const { character, natures } = current();
    return naturesInUse(character, natures).find((each) => each.joint === joint) ?? found;
  };
  const name = state.character.skeleton.names[joint]!;
  const editOf = (change: Partial<OwnNature>, label: string) => {
    const { stiffness, bend, side, twist } = nature();
    return setNature(current(), { joint, stiffness, bend, side, twist, ...change }, label);
  };
  const rows = [
    addValueRow(folder, {
      name: 'Stiffness',
      fullName: `${name} stiffness`,
      minimum: 0.1,
      maximum: 20,
      isAngle: false,
      locked: false,
      legal: [1 / stiffest, stiffest],
      read: () => nature().stiffness,
      begin: () => store.begin(`Change the stiffness of ${name}`),
      preview: (gesture, stiffness) =>
        gesture.preview(editOf({ stiffness }, `Change the stiffness of ${name}`)),
      reset: () => {
        const { stiffness } = found;
        store.dispatch(editOf({ stiffness }, `Reset the stiffness of ${name}`));
      },
    }),
    ...ranges.flatMap((range) => [0, 1].map((end) => addEnd(range, end as 0 | 1))),
  ];
  addCommandRow(folder, editor, 'reset-nature');
  return rows;

  function addEnd({ name: key, label }: (typeof ranges)[number], end: 0 | 1): ValueRow {
    const words = `${label} ${end === 0 ? 'from' : 'to'}`;
    const changed = `Change how far ${name} moves`;
    /** An end that passes the other one takes it along. */
    const withEnd = (value: number): Partial<OwnNature> => {
      const [low, high] = nature()[key];
      const moved = end === 0 ? [value, Math.max(high, value)] : [Math.min(low, value), value];
      return { [key]: moved };
    };
    return addValueRow(folder, {
      name: words,
      fullName: `${name} ${words.toLowerCase()}`,
      minimum: -Math.PI,
      maximum: Math.PI,
      isAngle: true,
      locked: false,
      legal: [-2 * Math.PI, 2 * Math.PI],
      read: () => nature()[key][end],
      begin: () => store.begin(changed),
      preview: (gesture, value) => gesture.preview(editOf(withEnd(value), changed)),
      reset: () => store.dispatch(editOf(withEnd(found[key][end]), `Reset ${name} ${words}`)),
    });
  }
}
