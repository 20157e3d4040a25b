import { bonesOf } from '../core/bones.ts';
import type { Character } from '../core/character.ts';
import type { ChannelParts, ClipParts } from '../core/motion/clip-parts.ts';
import type { TrailSettings } from '../document/motion-view.ts';
import { type Actor, type ActorId, boundClip } from '../document/scene.ts';
import { chainLength, pathTo } from '../posing/ik/chain.ts';
import { placeOf } from '../posing/ik/chain-problem.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import { changedSpan } from './changed-span.ts';
import { keyTimes } from './ghost-times.ts';
import type { Moments } from './moments.ts';

/** The path of a point of a joint over a part of the bound clip. */
export interface Trail {
  readonly actorId: ActorId;
  readonly joint: number;
  /** In the joint's frame. */
  readonly point: Vector3;
  /** At each frame, increasing in time. */
  readonly frames: readonly TrailPoint[];
  /** At each key of the joint and of the others in the chain that moves it. */
  readonly keys: readonly TrailPoint[];
}

export interface TrailPoint {
  /** In seconds of the clip. */
  readonly time: number;
  /** In the character's space. */
  readonly place: Vector3;
}

/** What the places depend on. */
interface Basis {
  readonly actor: Actor;
  readonly clip: ClipParts;
}

/**
 * Computes trails by evaluations of their own. Places are kept until something changes that they
 * depend on; an edit of the clip recomputes only the frames that it can reach.
 */
export class Trails {
  private readonly moments: Moments;
  private readonly known = new Map<ActorId, { basis: Basis; joints: Map<number, Float64Array> }>();

  constructor(moments: Moments) {
    this.moments = moments;
  }

  /**
   * Returns the trails of some joints of an actor; none if no clip is bound.
   *
   * @param present in seconds of the clip
   */
  of(
    actor: Actor,
    joints: readonly number[],
    { frames, point: way }: TrailSettings,
    present: number,
  ): readonly Trail[] {
    const clip = boundClip(actor);
    if (!clip) return [];
    const places = this.placesOf({ actor, clip });
    const times = framesOf(clip, present, frames);
    const [first = 0, last = 0] = [times[0], times.at(-1)];
    return joints.map((joint) => {
      const point = way === 'end' ? endOf(actor.character, joint) : origin;
      const at = (time: number): TrailPoint => ({
        time,
        place: placeOf(this.jointsAt(actor, places, time), joint, point),
      });
      const keys = keyTimes(chainChannels(clip, actor, joint));
      return {
        ...{ actorId: actor.id, joint, point },
        frames: times.map(at),
        keys: keys.filter((time) => time >= first && time <= last).map(at),
      };
    });
  }

  /** Forgets the places of actors that show no trail. */
  keepOnly(ids: readonly ActorId[]): void {
    for (const id of this.known.keys()) if (!ids.includes(id)) this.known.delete(id);
  }

  /** The matrices of all joints by time, as far as they are still right. */
  private placesOf(basis: Basis): Map<number, Float64Array> {
    const { id, pins } = basis.actor;
    const former = this.known.get(id);
    const follows = pins.some((pin) => pin.follows);
    const joints =
      former && !follows && hasSameState(former.basis.actor, basis.actor)
        ? former.joints
        : new Map<number, Float64Array>();
    if (former && joints === former.joints) {
      const [from, to] = changedSpan(former.basis.clip, basis.clip);
      for (const time of joints.keys()) if (time >= from && time <= to) joints.delete(time);
    }
    this.known.set(id, { basis, joints });
    return joints;
  }

  private jointsAt(actor: Actor, known: Map<number, Float64Array>, time: number): Float64Array {
    let joints = known.get(time);
    if (!joints) {
      const evaluation = this.moments.at('trail', actor, time);
      joints = evaluation.characterFromJoint.slice();
      // What is still loading changes the places when it comes.
      if (evaluation.pending.length === 0) known.set(time, joints);
    }
    return joints;
  }
}

const origin: Vector3 = [0, 0, 0];

/** The end of the first bone of a joint, in its frame; of a joint without one, the joint itself. */
function endOf(character: Character, joint: number): Vector3 {
  return bonesOf(character).find((bone) => bone.joint === joint)?.vector ?? origin;
}

function hasSameState(a: Actor, b: Actor): boolean {
  return a.character === b.character && a.q === b.q && a.pins === b.pins && a.natures === b.natures;
}

/** The times of the clip's frames, or of some about the present, in seconds. */
function framesOf(
  { start, end, fps }: ClipParts,
  present: number,
  around: number | null,
): number[] {
  const count = Math.floor((end - start) * fps + 1e-6);
  const now = Math.round((present - start) * fps);
  const first = around === null ? 0 : Math.max(0, now - around);
  const last = around === null ? count : Math.min(count, now + around);
  return Array.from(
    { length: Math.max(0, last - first + 1) },
    (_, at) => start + (first + at) / fps,
  );
}

/** The channels of the joints of the chain that moves a joint; see `chainLength`. */
function chainChannels(
  { channels }: ClipParts,
  { character: { skeleton }, pins }: Actor,
  joint: number,
): readonly ChannelParts[] {
  const chain = pathTo(skeleton, joint).slice(-chainLength(skeleton, joint, null, pins));
  const sources = new Set(chain.map((each) => skeleton.sourceIndex[each]!));
  return channels.filter(
    ({ target }) =>
      (target?.of === 'value' || target?.of === 'rotation') && sources.has(target.joint),
  );
}
