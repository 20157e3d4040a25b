import type {
  ChannelTarget,
  Extrapolation,
  KeyParts,
  RotationCurve,
  RotationKeyParts,
} from '../../core/motion/clip-parts.ts';
import type { AnimatedThing } from '../../core/motion/targets.ts';
import type { JsonValue } from '../json/decoder.ts';

/** A motion as its file has it: by names, so that it belongs to no character yet. */
export interface Motion {
  readonly file: string;
  readonly name: string;
  /** The range that is played, in seconds. */
  readonly start: number;
  readonly end: number;
  readonly fps: number;
  readonly channels: readonly MotionChannel[];
  /** Every channel at its number in the file, also the doubles; undefined where it can't be used. */
  readonly listed: readonly (MotionChannel | undefined)[];
  /** Channels that can't be used, as the file has them, for saving. */
  readonly unread: readonly unknown[];
}

export interface MotionChannel {
  readonly target: NamedTarget;
  readonly curve: NamedCurve;
  /** The target in the file, for messages. */
  readonly place: JsonValue;
  /** The whole channel as the file has it. */
  readonly raw: unknown;
}

/** A curve without the thing that it moves. */
export type NamedCurve = NumberCurve | TurnCurve;

export interface NumberCurve {
  readonly of: 'number';
  readonly before: Extrapolation;
  readonly after: Extrapolation;
  readonly keys: readonly KeyParts[];
}

export interface TurnCurve {
  readonly of: 'rotation';
  readonly curve: RotationCurve;
  readonly before: Extrapolation;
  readonly after: Extrapolation;
  readonly keys: readonly RotationKeyParts[];
}

/** What a channel moves, by name. */
export interface NamedTarget {
  /** By which it is asked for, the clearest one first: `pin.Left foot.x`, `Left foot.x`. */
  readonly names: readonly [string, ...string[]];
  /** How its rotation goes from key to key, or null if its keys are numbers. */
  readonly rotation: RotationCurve | null;
  /** Finds it by its name, or reports that nothing has it. What `#` and an index name may be absent. */
  locate(thing: AnimatedThing, json: JsonValue): ChannelTarget | undefined;
  /** Whether a character can be moved so, or else reports why not. */
  check(thing: AnimatedThing, json: JsonValue): boolean;
}

/** A kind of target. To add one, write its file and add its row to `target-kinds.ts`. */
export interface TargetKind {
  /** The names of its fields. */
  readonly fields: readonly string[];
  /** Whether an object describes a target of this kind, by the names of its fields. */
  matches(fields: ReadonlyMap<string, JsonValue>): boolean;
  /** Reads a target, or reports what is wrong with it. */
  read(fields: ReadonlyMap<string, JsonValue>): NamedTarget | undefined;
  /** Describes a target as the file has it; nothing if it is of another kind. */
  write(target: ChannelTarget, thing: AnimatedThing): Readonly<Record<string, unknown>> | undefined;
}
