import type { Character } from '../../core/character.ts';
import type { ClipParts } from '../../core/motion/clip-parts.ts';
import type { JsonValue } from '../../formats/json/decoder.ts';
import { decodePose } from '../../formats/pose-json.ts';
import { defaultDeformation, methods, normalWays } from '../../skinning/registry.ts';
import { type Actor, type ActorId, createActor, type Source } from '../scene.ts';
import { readClips, writeClips } from './clips-json.ts';
import { countFrom1, flag, index, numbersByName, oneOf, orNull, text } from './codec.ts';
import { type Codecs, readFields, writeFields } from './fields.ts';
import { readJointValues, writeJointValues } from './joint-values.ts';
import { indexOfKey, keyAt } from '../../formats/json/keys.ts';
import { lookJson } from './look-json.ts';
import { readMorphWeights, writeMorphWeights } from './morph-weights.ts';
import { readNatures, writeNatures } from './natures-json.ts';
import { type FindActor, readPins, writePins } from './pins-json.ts';
import { readSkin, writeSkin } from './skin-json.ts';
import { transformJson } from './transform-json.ts';
import { readUnkeyed, writeUnkeyed } from './unkeyed-json.ts';

/** The fields of an actor that are read without its character. To save another one, add its row. */
type PlainFields = Omit<
  Actor,
  | 'id'
  | 'character'
  | 'source'
  | 'q'
  | 'pins'
  | 'natures'
  | 'morphWeights'
  | 'clips'
  | 'clip'
  | 'unkeyed'
  | 'skin'
>;

const plainFields: Codecs<PlainFields> = {
  name: text,
  transform: transformJson,
  fitted: flag,
  method: oneOf(methods.map(({ id }) => id)),
  methodSettings: numbersByName,
  normals: oneOf(normalWays.map(({ id }) => id)),
  normalizeWeights: flag,
  influences: orNull(countFrom1),
  look: lookJson,
};

/** The fields that need the character. `pose` is as in POSE.json, for people who write by hand. */
const characterFields = [
  ...[
    'character',
    'values',
    'pose',
    'pins',
    'natures',
    'morphs',
    'clips',
    'clip',
    'unkeyed',
    'weights',
  ],
] as const;

/** An actor whose character may still be on its way. */
export interface ActorDescription {
  /** An index of the scene's characters. */
  readonly character: number;
  readonly plain: Partial<PlainFields>;
  /** The whole value. */
  readonly json: JsonValue;
}

/**
 * Writes an actor with an index of the scene's characters.
 *
 * @param actors all of the scene, which pins may follow
 */
export function writeActor(
  actor: Actor,
  character: number,
  actors: readonly Actor[],
): Record<string, unknown> {
  const { skeleton, morphs } = actor.character;
  const values = writeJointValues(skeleton, actor.q);
  const natures = writeNatures(actor.natures, skeleton);
  const weights = writeMorphWeights(namesOf(morphs), actor.morphWeights);
  const clips = writeClips(actor);
  return {
    character,
    ...writeFields(plainFields, actor, freshActor(actor.id, actor.character, actor.source)),
    ...(Object.keys(values).length > 0 && { values }),
    ...(actor.pins.length > 0 && { pins: writePins(actor, actors) }),
    ...(natures && { natures }),
    ...(Object.keys(weights).length > 0 && { morphs: weights }),
    ...(clips && { clips }),
    ...(actor.clip !== null && { clip: keyAt(namesOf(actor.clips), actor.clip) }),
    ...(actor.skin && { weights: writeSkin(actor.skin, actor.character) }),
    ...(actor.unkeyed && { unkeyed: writeUnkeyed(actor.unkeyed, actor.character) }),
  };
}

export function readActor(json: JsonValue): ActorDescription | undefined {
  const plain = readFields(plainFields, json, characterFields);
  if (!plain) return undefined;
  const character = index.read(json.member('character'));
  return character === undefined ? undefined : { character, plain, json };
}

/**
 * Makes the actor that was described. What does not fit its character is reported and left out.
 *
 * @param found returns which of the scene's actors has an index, if it is there, for pins that follow
 */
export function actorOf(
  { plain, json }: ActorDescription,
  id: ActorId,
  character: Character,
  source: Source,
  found: FindActor = () => undefined,
): Actor {
  const { skeleton, morphs } = character;
  const members = json.record('an object');
  const [values, pose, pins, natures, morphWeights, clips, clip, unkeyed, weights] = [
    ...['values', 'pose', 'pins', 'natures', 'morphs', 'clips', 'clip', 'unkeyed', 'weights'],
  ].map((key) => members?.get(key));
  const fresh = freshActor(id, character, source);
  const q = (pose && decodePose(pose, skeleton).value?.q) ?? fresh.q;
  if (values) readJointValues(values, skeleton, q);
  const held = pins ? readPins(pins, skeleton, found) : fresh.pins;
  const listed = (clips && readClips(clips, character)) ?? fresh.clips;
  const kept = clips ? listed.filter((each) => each !== undefined) : fresh.clips;
  return {
    ...fresh,
    ...plain,
    q,
    pins: held,
    natures: natures ? readNatures(natures, skeleton) : fresh.natures,
    morphWeights: morphWeights
      ? readMorphWeights(morphWeights, namesOf(morphs))
      : fresh.morphWeights,
    clips: kept,
    clip: clip ? readBoundClip(clip, listed) : null,
    unkeyed: unkeyed
      ? readUnkeyed(
          unkeyed,
          character,
          held.map(({ joint }) => joint),
        )
      : null,
    skin: weights ? readSkin(weights, character) : null,
  };
}

/** An actor as its files have it. */
function freshActor(id: ActorId, character: Character, source: Source): Actor {
  return createActor(id, character, defaultDeformation(character).method, { source });
}

/**
 * Returns the index of the bound clip among those that were read.
 *
 * @param clips as they are listed, with missing ones, because keys count them
 */
function readBoundClip(json: JsonValue, clips: readonly (ClipParts | undefined)[]): number | null {
  const key = text.read(json);
  if (key === undefined) return null;
  const names = clips.map((clip) => clip?.name ?? '#');
  const listed = indexOfKey(names, key);
  if (clips[listed]) return clips.slice(0, listed).filter((clip) => clip !== undefined).length;
  json.fail('unknown', 'the name of a clip of the character, or # and its index');
  return null;
}

function namesOf(things: readonly { readonly name: string }[]): readonly string[] {
  return things.map(({ name }) => name);
}
