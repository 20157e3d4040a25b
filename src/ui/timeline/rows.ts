import {
  type ChannelParts,
  type ClipParts,
  isRotationChannel,
  type ScalarTarget,
} from '../../core/motion/clip-parts.ts';
import { type AnimatedThing, channelKey } from '../../core/motion/targets.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { subtreeEnd } from '../../core/subtree.ts';
import { axisNames } from '../joint-values.ts';

/** Stays the same while the clip is edited, so that folds and the focus stay with their rows. */
export type RowId = string;

export type Axis = 'x' | 'y' | 'z';

/** A row of the timeline: the keys of some channels, merged. */
export interface TimelineRow {
  readonly id: RowId;
  /** What it stands for: everything, a joint, several morphs or pins, or one channel. */
  readonly kind: 'all' | 'joint' | 'group' | 'channel';
  readonly label: string;
  /** Understood without the rows above it: "Right elbow X". */
  readonly fullName: string;
  /** Counted from 1, as in ARIA. */
  readonly level: number;
  /** That a click on the name selects, or null. */
  readonly joint: number | null;
  readonly channels: readonly ChannelParts[];
  /** Whether the rows of the joints below it are shown; null if it has none. */
  readonly showsBranch: boolean | null;
  /** Whether a row for each of its channels is shown; null if it has none. */
  readonly showsChannels: boolean | null;
  /** The color of a channel's name, or null. */
  readonly axis: Axis | null;
}

export interface RowChoices {
  /** What is folded or unfolded unlike at first: ids of rows, after "branch " or "channels ". */
  readonly turned: ReadonlySet<string>;
  /** Whether joints that the clip does not move have rows too. */
  readonly allJoints: boolean;
  /** Whose rows are repeated at the top, with their channels. */
  readonly selected: readonly number[];
}

/** The rows of a clip: a summary, the selected joints, all joints as a tree, morphs, pins. */
export function timelineRows(
  clip: ClipParts,
  thing: AnimatedThing,
  choices: RowChoices,
): readonly TimelineRow[] {
  const { skeleton } = thing;
  const { own, known } = channelsOf(clip, skeleton);
  const all = { label: 'All', fullName: 'All', channels: known };
  const selected = choices.selected.flatMap((joint) => {
    const channels = own.get(joint) ?? [];
    const id = `selected ${joint}`;
    const row = { ...jointRow(skeleton, id, joint), channels };
    return withChannels(row, thing, !choices.turned.has(`channels ${id}`));
  });
  return [
    { ...plain, ...all, id: 'all', kind: 'all' },
    ...selected,
    ...jointRows(thing, own, choices),
    ...group('morph', 'Morphs', clip, thing, choices),
    ...group('pin', 'Pins', clip, thing, choices),
  ];
}

const plain = {
  level: 1,
  joint: null,
  showsBranch: null,
  showsChannels: null,
  axis: null,
} as const;

function jointRow(skeleton: Skeleton, id: RowId, joint: number): TimelineRow {
  const label = skeleton.names[joint]!;
  return { ...plain, id, kind: 'joint', label, fullName: label, joint, channels: [] };
}

const none: readonly ChannelParts[] = [];

/** The tree of joints, in which those without rows are left out and their children move up. */
function jointRows(
  thing: AnimatedThing,
  own: ReadonlyMap<number, readonly ChannelParts[]>,
  { allJoints, turned }: RowChoices,
): readonly TimelineRow[] {
  const { skeleton } = thing;
  const isShown = (joint: number): boolean => allJoints || own.has(joint);
  /** The ends of the shown joints' subtrees in which the present joint is. */
  const ends: number[] = [];
  const rows: TimelineRow[] = [];
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    if (!isShown(joint)) continue;
    while (ends.length > 0 && ends.at(-1)! <= joint) ends.pop();
    const end = subtreeEnd(skeleton, joint);
    const below = range(joint + 1, end).filter(isShown);
    const id = `joint ${joint}`;
    const showsBranch = below.length > 0 ? !turned.has(`branch ${id}`) : null;
    const level = ends.length + 1;
    // A folded branch shows the keys of all that it hides.
    const channels =
      showsBranch === false
        ? [joint, ...below].flatMap((each) => own.get(each) ?? [])
        : (own.get(joint) ?? none);
    const row = { ...jointRow(skeleton, id, joint), level, channels, showsBranch };
    if (showsBranch === false) {
      rows.push(row);
      joint = end - 1;
      continue;
    }
    rows.push(...withChannels(row, thing, turned.has(`channels ${id}`)));
    ends.push(end);
  }
  return rows;
}

/** The morphs or the pins of a clip below one row, if it has any. */
function group(
  of: 'morph' | 'pin',
  label: string,
  { channels: all }: ClipParts,
  thing: AnimatedThing,
  { turned }: RowChoices,
): readonly TimelineRow[] {
  const channels = all.filter(({ target }) => target?.of === of);
  if (channels.length === 0) return [];
  const row: TimelineRow = { ...plain, id: of, kind: 'group', label, fullName: label, channels };
  return withChannels(row, thing, turned.has(`channels ${of}`));
}

/** A row and, if they are shown, the rows of its channels. */
function withChannels(
  row: TimelineRow,
  thing: AnimatedThing,
  showsChannels: boolean,
): readonly TimelineRow[] {
  if (row.channels.length === 0) return [row];
  const shown = row.channels
    .map((channel): TimelineRow & { readonly order: number } => {
      const { label, fullName, axis, order } = nameOf(channel, thing);
      const id = `${row.id} ${channelKey(channel.target!)}`;
      const { joint, level } = row;
      const above = { ...plain, joint, level: level + 1 };
      return { ...above, id, kind: 'channel', label, fullName, axis, order, channels: [channel] };
    })
    .sort((a, b) => a.order - b.order);
  return [{ ...row, showsChannels }, ...(showsChannels ? shown : [])];
}

interface ChannelName {
  readonly label: string;
  readonly fullName: string;
  readonly axis: Axis | null;
  /** Among the channels of its row: moves before turns, by axis. */
  readonly order: number;
}

const axes: readonly Axis[] = ['x', 'y', 'z'];

function nameOf(channel: ChannelParts, { skeleton, morphs }: AnimatedThing): ChannelName {
  const nameOfJoint = (source: number): string =>
    skeleton.names[skeleton.jointOfSource[source]!] ?? `#${source}`;
  if (isRotationChannel(channel)) {
    const name = nameOfJoint(channel.target.joint);
    return { label: 'Rotation', fullName: `${name} rotation`, axis: null, order: 6 };
  }
  const target: ScalarTarget = channel.target!;
  switch (target.of) {
    case 'value': {
      const isMove = target.kind === DofKind.slide;
      const label = `${isMove ? 'Move ' : ''}${axisNames[target.axis]}`;
      const order = target.axis + (isMove ? 0 : 3);
      const fullName = `${nameOfJoint(target.joint)} ${label}`;
      return { label, fullName, axis: axes[target.axis]!, order };
    }
    case 'morph': {
      const label = morphs[target.morph]?.name ?? `#${target.morph}`;
      return { label, fullName: label, axis: null, order: target.morph };
    }
    case 'pin': {
      const at = axes.indexOf(target.value as Axis);
      const value = axisNames[at] ?? 'weight';
      const label = `${nameOfJoint(target.joint)} ${value}`;
      const order = target.joint * 4 + (at < 0 ? 3 : at);
      return { label, fullName: `Pin of ${label}`, axis: axes[at] ?? null, order };
    }
  }
}

interface ClipChannels {
  /** Those whose target is known. */
  readonly known: readonly ChannelParts[];
  /** The channels of each joint that has any. */
  readonly own: ReadonlyMap<number, readonly ChannelParts[]>;
}

/** Sorts a clip's channels, once: what is merged of a list of them is kept with the list. */
function channelsOf(clip: ClipParts, skeleton: Skeleton): ClipChannels {
  let found = sorted.get(clip);
  if (found?.skeleton !== skeleton) {
    const known = clip.channels.filter(({ target }) => target !== null);
    sorted.set(clip, (found = { skeleton, known, own: channelsByJoint(clip, skeleton) }));
  }
  return found;
}

const sorted = new WeakMap<ClipParts, ClipChannels & { readonly skeleton: Skeleton }>();

function channelsByJoint(
  { channels }: ClipParts,
  { jointOfSource }: Skeleton,
): ReadonlyMap<number, readonly ChannelParts[]> {
  const found = new Map<number, ChannelParts[]>();
  for (const channel of channels) {
    const { target } = channel;
    if (target?.of !== 'value' && target?.of !== 'rotation') continue;
    const joint = jointOfSource[target.joint];
    if (joint === undefined) continue;
    const list = found.get(joint);
    if (list) list.push(channel);
    else found.set(joint, [channel]);
  }
  return new Map([...found].map(([joint, list]) => [joint, shared(list)]));
}

/** The same list for the same channels, whatever else of the clip was edited. */
function shared(list: readonly ChannelParts[]): readonly ChannelParts[] {
  const former = lists.get(list[0]!);
  const isSame =
    former?.length === list.length && former.every((channel, at) => channel === list[at]);
  if (isSame) return former;
  lists.set(list[0]!, list);
  return list;
}

const lists = new WeakMap<ChannelParts, readonly ChannelParts[]>();

function range(start: number, end: number): readonly number[] {
  return Array.from({ length: Math.max(0, end - start) }, (_, i) => start + i);
}
