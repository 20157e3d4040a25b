import { channelFor } from '../../core/motion/channel.ts';
import { isRotationChannel, type KeyParts, type Tangent } from '../../core/motion/clip-parts.ts';
import { moveKeys } from '../../core/motion/edit/move-keys.ts';
import { type SelectedKey, selectedIn } from '../../core/motion/edit/selection.ts';
import { changeKey } from '../../core/motion/edit/set-key.ts';
import { setTangents } from '../../core/motion/edit/tangents.ts';
import type { KeySelection } from '../../core/motion/key-selection.ts';
import type { Editor } from '../editor.ts';
import { changeValues, oneKey } from './curve-edits.ts';
import { curveModel } from './curve-model.ts';
import { parseChange, parseTangent, parseTime, tangentText } from './key-text.ts';
import type { ValueUnit } from './value-axis.ts';

/** The selected keys as fields show them. */
export interface TypedKeys {
  readonly count: number;
  /** In seconds: the one time of them all, or null. */
  readonly time: number | null;
  /** The one value of them all, or null, as of rotations. */
  readonly value: number | null;
  readonly unit: ValueUnit;
  readonly hasValues: boolean;
  readonly tangents: Readonly<Record<'in' | 'out', Tangent | null>>;
  /** The slopes of a key that is alone, in value a second. */
  readonly slopes: Readonly<Record<'in' | 'out', number>> | null;
}

/** What the selected keys have in common; null if none is selected. */
export function typedKeysOf(editor: Editor): TypedKeys | null {
  const model = curveModel(editor);
  const clip = model.shown.value?.parts;
  const found = clip ? selectedIn(clip, model.selection.value) : [];
  if (found.length === 0) return null;
  const scalars = found.flatMap(scalarKey);
  const units = new Set(found.map(({ channelKey }) => model.unitOf(channelKey)));
  const unit = units.size === 1 ? [...units][0]! : 'number';
  return {
    count: found.length,
    time: common(found.map(({ channel, index }) => channel.keys[index]!.time)),
    value: scalars.length === found.length ? common(scalars.map(({ value }) => value)) : null,
    unit,
    hasValues: scalars.length > 0,
    tangents: {
      in: commonTangent(scalars.map(({ tangentIn }) => tangentIn)),
      out: commonTangent(scalars.map(({ tangentOut }) => tangentOut)),
    },
    slopes: found.length === 1 ? slopesAt(found[0]!) : null,
  };
}

function scalarKey({ channel, index }: SelectedKey): readonly KeyParts[] {
  return isRotationChannel(channel) ? [] : [channel.keys[index]!];
}

function slopesAt({ channel, index }: SelectedKey): TypedKeys['slopes'] {
  if (isRotationChannel(channel)) return null;
  const { slopesIn, slopesOut } = channelFor(channel);
  return { in: slopesIn[index]!, out: slopesOut[index]! };
}

function common(values: readonly number[]): number | null {
  const [first] = values;
  return first !== undefined && values.every((each) => each === first) ? first : null;
}

function commonTangent(tangents: readonly Tangent[]): Tangent | null {
  const [first] = tangents;
  if (first === undefined) return null;
  const text = tangentText(first);
  return tangents.every((each) => each === first || tangentText(each) === text) ? first : null;
}

/** Moves the selected keys so that the first of them is at a typed time. */
export function typeTime(editor: Editor, text: string): boolean {
  const model = curveModel(editor);
  const { session } = editor;
  const clip = model.shown.peek()?.parts;
  const time = clip ? parseTime(text, clip.fps) : null;
  if (!clip || time === null) return false;
  const keys = model.selection.peek();
  const first = Math.min(...[...keys.values()].flat());
  const moved = moveKeys(clip, keys, { seconds: time - first });
  model.edit('Set the time of keys', () => moved.clip);
  session.selectedKeys.value = new Map([...session.selectedKeys.peek(), ...moved.selection]);
  return true;
}

/** Sets the values of the selected keys, or changes each by "+=", "-=" or "*=". */
export function typeValue(editor: Editor, text: string, unit: ValueUnit): boolean {
  const model = curveModel(editor);
  const change = parseChange(text, unit);
  if (!change) return false;
  const keys = model.selection.peek();
  model.edit('Set the value of keys', (clip) => changeValues(clip, keys, change));
  return true;
}

/** Sets the tangents of the selected keys on one side: a rule, or a slope. */
export function typeTangent(
  editor: Editor,
  side: 'in' | 'out',
  text: string,
  unit: ValueUnit,
): boolean {
  const model = curveModel(editor);
  const tangent = parseTangent(text, unit);
  if (tangent === null) return false;
  const keys = model.selection.peek();
  model.edit('Set the tangents of keys', (clip) => setTangents(clip, keys, side, tangent));
  return true;
}

/** A cell of the table of keys. */
export type KeyCell = 'time' | 'frame' | 'value' | 'in' | 'out';

/** Changes one key of the shown channel; returns whether the text was understood. */
export function typeCell(editor: Editor, at: number, cell: KeyCell, text: string): boolean {
  const model = curveModel(editor);
  const curve = model.curve.peek();
  const clip = model.shown.peek()?.parts;
  const time = curve?.channel.keys[at]?.time;
  if (!curve || !clip || time === undefined) return false;
  const keys: KeySelection = oneKey(curve.key, time);
  if (cell === 'value') {
    const change = parseChange(text, curve.unit);
    if (change) model.edit('Set the value of a key', (now) => changeValues(now, keys, change));
    return change !== null;
  }
  if (cell === 'in' || cell === 'out') {
    const tangent = parseTangent(text, curve.unit);
    if (tangent === null) return false;
    model.edit('Set the tangent of a key', (now) => setTangents(now, keys, cell, tangent));
    return true;
  }
  const typed = parseTime(cell === 'frame' ? `f ${text.replace(/^f/i, '')}` : text, clip.fps);
  if (typed === null) return false;
  const moved = changeKey(clip, curve.key, time, { time: typed });
  model.edit('Set the time of a key', () => moved.clip);
  editor.session.selectedKeys.value = moved.selection;
  return true;
}
