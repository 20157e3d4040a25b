import { computed, signal } from '@preact/signals-core';
import type { ClipParts } from '../../core/motion/clip-parts.ts';
import { sameTime } from '../../core/motion/edit/keys.ts';
import type { TangentSide } from '../../core/motion/edit/tangents.ts';
import type { KeySelection } from '../../core/motion/key-selection.ts';
import type { ChannelKey } from '../../core/motion/targets.ts';
import { firstRoot } from '../../core/subtree.ts';
import { editClip } from '../../document/clip-edits.ts';
import type { Edit } from '../../document/edit.ts';
import type { Actor } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { selectedJoints } from '../../document/selected-joints.ts';
import type { Editor } from '../editor.ts';
import { shownWindow } from '../timeline/shown-time.ts';
import { framing, type TimeWindow } from '../timeline/time-axis.ts';
import { boundsOf, type PlotLine, plotLines } from './plot-lines.ts';
import { type CurveScale, framingValues, type Place, type ValueWindow } from './plot.ts';
import { type ShownCurve, shownCurves } from './shown-curves.ts';
import type { ValueUnit } from './value-axis.ts';

type Keys = ReadonlySet<ChannelKey>;
const none: Keys = new Set();

/** The clip that is shown. */
interface ShownClip {
  readonly actor: Actor;
  readonly index: number;
  readonly parts: ClipParts;
}

/** A key that is to be inserted into a rotation, which would then turn elsewhere. */
export interface AskedKey {
  readonly channel: ChannelKey;
  readonly time: number;
  /** The largest change of the rotation, in radians. */
  readonly turn: number;
}

/** How the curves are looked at, and what is computed of it. It is neither saved nor undone. */
export class CurveModel {
  readonly isNormalized = signal(false);
  /** Whether the curves of all joints are listed. */
  readonly showsAll = signal(false);
  readonly showsTable = signal(false);
  /** Whether a drag of a handle turns its own side alone. */
  readonly breaksHandles = signal(false);
  /** The side of keys that tangents are given to. */
  readonly side = signal<TangentSide>('both');
  readonly hidden = signal(none);
  readonly locked = signal(none);
  /** The channel that was chosen last in the list or by one of its keys. */
  readonly chosen = signal<ChannelKey | null>(null);
  /** The values that the plot shows; null is all of them. */
  readonly values = signal<ValueWindow | null>(null);
  /** During a gesture, the scales at its beginning, so that no curve moves under the pointer. */
  readonly heldScales = signal<ReadonlyMap<ChannelKey, CurveScale> | null>(null);
  /** What a gesture does, in words. */
  readonly telling = signal('');
  /** Where the fields of the selected keys stand, or null while they are closed. */
  readonly fieldsAt = signal<Place | null>(null);
  readonly asked = signal<AskedKey | null>(null);

  private readonly editor: Editor;

  constructor(editor: Editor) {
    this.editor = editor;
  }

  readonly shown = computed<ShownClip | null>(() => {
    const { store, session, transport } = this.editor;
    const actor = selectedActor(store, session);
    const index = transport.clipIndex;
    const parts = actor?.clips[index];
    return actor && parts ? { actor, index, parts } : null;
  });

  readonly curves = computed<readonly ShownCurve[]>(() => {
    const clip = this.shown.value;
    if (!clip) return [];
    const { character } = clip.actor;
    const all = { joints: null, morphs: true };
    if (this.showsAll.value) return shownCurves(clip.parts, character, all);
    const joints = selectedJoints(this.editor.session);
    if (joints.length > 0) return shownCurves(clip.parts, character, { joints, morphs: false });
    const roots = { joints: [firstRoot(character.skeleton)], morphs: true };
    const found = shownCurves(clip.parts, character, roots);
    return found.length > 0 ? found : shownCurves(clip.parts, character, all);
  });

  readonly lines = computed<readonly PlotLine[]>(() => {
    const seen = this.curves.value.filter(({ key }) => !this.hidden.value.has(key));
    const lines = plotLines(seen, this.isNormalized.value);
    const held = this.heldScales.value;
    if (!held) return lines;
    return lines.map((line) => ({ ...line, scale: held.get(line.key) ?? line.scale }));
  });

  readonly scales = computed<ReadonlyMap<ChannelKey, CurveScale>>(
    () => new Map(this.lines.value.map(({ key, scale }) => [key, scale])),
  );

  readonly timeWindow = computed<TimeWindow>(() => {
    const clip = this.shown.value;
    return clip ? shownWindow(this.editor.session, clip.parts) : [0, 1];
  });

  readonly valueWindow = computed<ValueWindow>(() => {
    return this.values.value ?? framingValues(boundsOf(this.lines.value)?.values ?? [-1, 1]);
  });

  /** The chosen curve while it is listed, or else the first one that moves anything. */
  readonly curve = computed<ShownCurve | null>(() => {
    const curves = this.curves.value;
    const chosen = curves.find(({ key }) => key === this.chosen.value);
    return chosen ?? curves.find(({ channel }) => channel.keys.length > 1) ?? curves[0] ?? null;
  });

  /** The selected keys of curves that are seen and not locked. */
  readonly selection = computed<KeySelection>(() => {
    const seen = new Set(this.lines.value.map(({ key }) => key));
    const open = [...this.editor.session.selectedKeys.value].filter(
      ([key]) => seen.has(key) && !this.locked.value.has(key),
    );
    return new Map(open);
  });

  private readonly units = computed<ReadonlyMap<ChannelKey, ValueUnit>>(
    () => new Map(this.curves.value.map(({ key, unit }) => [key, unit])),
  );

  /** What a channel's values are measured in. */
  unitOf(key: ChannelKey): ValueUnit {
    return this.units.value.get(key) ?? 'number';
  }

  /** An edit of the shown clip. */
  editOf(label: string, edit: (clip: ClipParts) => ClipParts): Edit | null {
    const clip = this.shown.peek();
    return clip && editClip(clip.actor.id, clip.index, label, edit);
  }

  /** Edits the shown clip as one step of undo, and shows the scene at the playhead. */
  edit(label: string, edit: (clip: ClipParts) => ClipParts): void {
    const made = this.editOf(label, edit);
    if (!made) return;
    this.bind();
    this.editor.store.dispatch(made);
  }

  /** Lets the scene follow the clip that is edited. */
  bind(): void {
    const { session, transport } = this.editor;
    if (!transport.isBound) transport.seek(session.clipTime.peek());
  }

  /** Shows the selected keys in both axes, or all of them if fewer than two are selected. */
  frame(): void {
    const lines = this.lines.value;
    const bounds = boundsOf(selectedParts(lines, this.selection.value)) ?? boundsOf(lines);
    if (!bounds) return;
    this.editor.session.timeWindow.value = framing(bounds.times);
    this.values.value = framingValues(bounds.values);
  }

  /** Selects all keys that are seen and not locked. */
  selectAll(): void {
    const open = this.lines.value.filter(({ key }) => !this.locked.value.has(key));
    this.editor.session.selectedKeys.value = new Map(
      open.map(({ key, times }) => [key, [...times]]),
    );
  }

  /** Keeps the scales and the window of values as they are, until `release`. */
  hold(): void {
    this.values.value = this.valueWindow.peek();
    this.heldScales.value = this.scales.peek();
  }

  release(): void {
    this.heldScales.value = null;
    this.telling.value = '';
  }
}

/** The lines cut down to their selected keys; none if fewer than two keys are selected. */
function selectedParts(lines: readonly PlotLine[], selection: KeySelection): readonly PlotLine[] {
  const parts = lines.map((line) => {
    const chosen = selection.get(line.key) ?? [];
    const isChosen = (time: number): boolean => chosen.some((each) => sameTime(each, time));
    const values = line.values.filter((_, at) => isChosen(line.times[at]!));
    return { ...line, times: line.times.filter(isChosen), values };
  });
  const count = parts.reduce((sum, { times }) => sum + times.length, 0);
  return count < 2 ? [] : parts.filter(({ times }) => times.length > 0);
}

const models = new WeakMap<Editor, CurveModel>();

export function curveModel(editor: Editor): CurveModel {
  let model = models.get(editor);
  if (!model) models.set(editor, (model = new CurveModel(editor)));
  return model;
}

export function toggled(keys: Keys, key: ChannelKey): Keys {
  const others = new Set(keys);
  if (!others.delete(key)) others.add(key);
  return others;
}
