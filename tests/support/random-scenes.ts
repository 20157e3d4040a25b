import fc from 'fast-check';
import { buildCharacter } from '../../src/core/build-character.ts';
import type { Character } from '../../src/core/character.ts';
import type { Skin } from '../../src/core/skin.ts';
import type { Light } from '../../src/document/environment.ts';
import { type Actor, type Scene, type Source, unmoved } from '../../src/document/scene.ts';
import type { SavedPose } from '../../src/document/saved-poses.ts';
import { changedSkin } from '../../src/document/skin-edits.ts';
import { aspects, type Shot } from '../../src/document/shots.ts';
import type { NatureSettings } from '../../src/posing/natural/nature-settings.ts';
import type { Pin } from '../../src/posing/pins/pin.ts';
import { normalWays, methods } from '../../src/skinning/registry.ts';
import { partsOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';
import { clipsOf } from './random-clips.ts';

/** Every rig, with morphs and clips whose names are odd or not unique. */
const characters = Object.values(allRigs).map((rig): Character => {
  const parts = partsOfRig(rig());
  const file = 'made';
  const empty = { points: new Uint32Array(0), offsets: new Float32Array(0) };
  const shape = { ...empty, normalPoints: empty.points, normalOffsets: empty.offsets };
  const names = ['smile', '#1', '__proto__', 'twice', 'twice'];
  return buildCharacter({
    ...parts,
    morphs: names.map((name) => ({ file, name, ...shape })),
    clips: names.map((name) => ({ file, name, start: 0, end: 1, fps: 30, channels: [] })),
  }).value!;
});

const number = fc.double({ min: -1e9, max: 1e9, noNaN: true });
const triple = fc.tuple(number, number, number);
const rotation = fc.tuple(number, number, number, number).map(([x, y, z, w]) => {
  const length = Math.hypot(x, y, z, w);
  const isLong = length > 1e-9;
  return isLong ? ([x / length, y / length, z / length, w / length] as const) : unmoved.rotation;
});

const color = fc.nat(0xffffff).map((value) => `#${value.toString(16).padStart(6, '0')}`);
const share = fc.double({ min: 0, max: 1, noNaN: true });

const light: fc.Arbitrary<Light> = fc.record({
  name: fc.string(),
  color,
  intensity: fc.double({ min: 0, max: 100, noNaN: true }),
  azimuth: fc.double({ min: -360, max: 360, noNaN: true }),
  elevation: fc.double({ min: -90, max: 90, noNaN: true }),
});

const shot: fc.Arbitrary<Shot> = fc.record({
  id: fc.nat(),
  name: fc.string(),
  camera: fc.record({
    target: triple,
    distance: fc.double({ min: 1e-3, max: 1e3, noNaN: true }),
    azimuth: fc.double({ min: -99, max: 99, noNaN: true }),
    elevation: fc.double({ min: -2, max: 2, noNaN: true }),
    fieldOfView: fc.double({ min: 0.01, max: 3, noNaN: true }),
    projection: fc.constantFrom('perspective', 'orthographic'),
  }),
  aspect: fc.constantFrom(...aspects.map(({ id }) => id)),
});

const namedJoint = fc
  .array(fc.constantFrom(...Array.from('xyzXYZshQ')), { minLength: 1, maxLength: 6 })
  .chain((letters) => {
    const length = letters.length + 3 * letters.filter((letter) => letter === 'Q').length;
    return fc.record({
      name: fc.string(),
      dofs: fc.constant(letters.join('')),
      values: fc.array(number, { minLength: length, maxLength: length }),
    });
  });

const savedPose: fc.Arbitrary<SavedPose> = fc.record({
  id: fc.nat(),
  name: fc.string(),
  height: fc.double({ min: 0, max: 1e6, noNaN: true }),
  joints: fc.array(namedJoint, { maxLength: 4 }),
  morphs: fc.array(fc.record({ name: fc.string(), weight: number }), { maxLength: 3 }),
});

const hash = fc
  .uint8Array({ minLength: 32, maxLength: 32 })
  .map((bytes) => Buffer.from(bytes).toString('hex'));

const source: fc.Arbitrary<Source> = fc.oneof(
  fc.record({ kind: fc.constant('bundled' as const), id: fc.string() }),
  fc.record({
    kind: fc.constant('files' as const),
    files: fc.array(fc.record({ path: fc.string(), sha256: hash }), { maxLength: 4 }),
  }),
);

function pinOf(jointCount: number): fc.Arbitrary<Pin> {
  return fc.record({
    joint: fc.nat(jointCount - 1),
    point: triple,
    place: triple,
    rotation: fc.option(rotation),
    weight: share,
    follows: fc.option(
      fc.record({ actor: fc.nat(4), joint: fc.nat(jointCount - 1), point: triple, rotation }),
    ),
  });
}

function naturesOf(jointCount: number): fc.Arbitrary<NatureSettings> {
  const angle = fc.double({ min: -6, max: 6, noNaN: true });
  const range = fc.tuple(angle, angle).map(([a, b]) => [Math.min(a, b), Math.max(a, b)] as const);
  const nature = fc.record({
    joint: fc.nat(jointCount - 1),
    stiffness: fc.double({ min: 0.001, max: 1000, noNaN: true }),
    bend: range,
    side: range,
    twist: range,
  });
  return fc.record({
    isOn: fc.boolean(),
    own: fc
      .uniqueArray(nature, { maxLength: 3, selector: ({ joint }) => joint })
      .map((own) => own.sort((a, b) => a.joint - b.joint)),
  });
}

/** Pins follow only actors before their own, so that there is no circle. */
function asScene(actors: readonly Omit<Actor, 'id'>[]): readonly Actor[] {
  return actors.map((actor, at) => {
    const pins = actor.pins.map((pin) => {
      const { actor: index = at, joint = 0 } = pin.follows ?? {};
      const other = actors[index];
      if (!pin.follows || !other || index >= at) return { ...pin, follows: null };
      const followed = joint % other.character.skeleton.jointCount;
      return { ...pin, follows: { ...pin.follows, actor: index + 1, joint: followed } };
    });
    return { ...actor, id: at + 1, pins };
  });
}

/** The weights of a character with other rows at a few points. */
function skinOf(character: Character): fc.Arbitrary<Skin | null> {
  const { start, paletteJoint } = character.skin;
  const influence = fc.record({
    entry: fc.nat(paletteJoint.length - 1),
    weight: fc.integer({ min: 1, max: 300 }).map((weight) => Math.fround(weight / 100 - 1)),
  });
  const row = fc.uniqueArray(influence, {
    ...{ minLength: 1, maxLength: 5, selector: ({ entry }) => entry },
  });
  return fc
    .array(fc.tuple(fc.nat(start.length - 2), row), { maxLength: 4 })
    .map((rows) => changedSkin(character, character.skin, new Map(rows)));
}

function actorOf(character: Character): fc.Arbitrary<Omit<Actor, 'id'>> {
  const { skeleton, morphs } = character;
  const values = fc.array(fc.option(number, { nil: undefined }), {
    minLength: skeleton.qRest.length,
    maxLength: skeleton.qRest.length,
  });
  const weight = fc.double({ min: -10, max: 10, noNaN: true });
  const actor = fc.record({
    name: fc.string(),
    character: fc.constant(character),
    source,
    transform: fc.record({
      position: triple,
      rotation,
      scale: fc.double({ min: 1e-6, max: 1e6, noNaN: true }),
    }),
    fitted: fc.boolean(),
    q: values.map((own) =>
      skeleton.qRest.map((rest, at) =>
        Math.min(Math.max(own[at] ?? rest, skeleton.qMin[at]!), skeleton.qMax[at]!),
      ),
    ),
    pins: fc.uniqueArray(pinOf(skeleton.jointCount), {
      maxLength: 3,
      selector: ({ joint }) => joint,
    }),
    natures: naturesOf(skeleton.jointCount),
    morphWeights: fc
      .array(weight, { minLength: morphs.length, maxLength: morphs.length })
      .map((weights) => Float64Array.from(weights)),
    clips: clipsOf(character),
    clip: fc.option(fc.nat(4)),
    unkeyed: fc.option(
      fc.record({
        time: number,
        values: indicesBelow(skeleton.qRest.length),
        morphs: indicesBelow(morphs.length),
        pins: indicesBelow(skeleton.jointCount),
      }),
    ),
    method: fc.constantFrom(...methods.map(({ id }) => id)),
    methodSettings: fc.dictionary(
      fc.constantFrom('blend', 'steps'),
      fc.double({ min: -100, max: 100, noNaN: true }),
    ),
    normals: fc.constantFrom(...normalWays.map(({ id }) => id)),
    normalizeWeights: fc.boolean(),
    influences: fc.option(fc.integer({ min: 1, max: 20 })),
    skin: skinOf(character),
    look: fc.record({
      visible: fc.boolean(),
      clay: fc.nat(7),
      roughness: fc.double({ min: 0, max: 1, noNaN: true }),
      shading: fc.constantFrom('smooth', 'faceted'),
      dragging: fc.constantFrom('follow', 'course'),
      surface: fc.constantFrom('file', 'clay', 'image', 'checker', 'uv'),
      projection: fc.constantFrom('uv', 'box', 'cylinder'),
      repeats: fc.double({ min: 0.01, max: 1000, noNaN: true }),
      image: fc.option(
        fc.record({
          name: fc.string(),
          textures: fc.constant([]),
          bytes: fc.uint8Array({ maxLength: 20 }),
        }),
      ),
    }),
  });
  return actor.map(withoutMissing);
}

function indicesBelow(count: number): fc.Arbitrary<readonly number[]> {
  return fc
    .uniqueArray(fc.nat(Math.max(count - 1, 0)), { maxLength: Math.min(count, 4) })
    .map((indices) => indices.sort((a, b) => a - b));
}

/** The actor with a bound clip only if it has that clip, and unkeyed pins only of its own. */
function withoutMissing(actor: Omit<Actor, 'id'>): Omit<Actor, 'id'> {
  const { clips, clip, pins, unkeyed } = actor;
  const pinned = pins.map(({ joint }) => joint);
  return {
    ...actor,
    clip: clip !== null && clip < clips.length ? clip : null,
    unkeyed: unkeyed && {
      ...unkeyed,
      pins: unkeyed.pins.filter((joint) => pinned.includes(joint)),
    },
  };
}

/** Scenes with every field at any legal value. */
export const randomScene: fc.Arbitrary<Scene> = fc.record({
  actors: fc.array(fc.constantFrom(...characters).chain(actorOf), { maxLength: 5 }).map(asScene),
  environment: fc.record({
    lights: fc.array(light, { minLength: 3, maxLength: 3 }),
    ambient: fc.record({ color, intensity: share }),
    shadow: fc.record({ kind: fc.constantFrom('mapped', 'planar', 'off'), darkness: share }),
    floor: fc.record({ kind: fc.constantFrom('checks', 'plain', 'off'), reflection: share }),
    background: fc.record({
      kind: fc.constantFrom('theme', 'color', 'gradient', 'transparent'),
      color,
      topColor: color,
    }),
  }),
  shots: fc.uniqueArray(shot, { maxLength: 4, selector: ({ id }) => id }),
  poses: fc.uniqueArray(savedPose, { maxLength: 3, selector: ({ id }) => id }),
});
