import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { jointRange } from '../../../src/core/pose.ts';
import { sameValue } from '../../../src/core/same-value.ts';
import { comparisonOf } from '../../../src/document/comparison.ts';
import { actorOf } from '../../../src/document/scene-json/actor-json.ts';
import { readScene, type SceneDescription } from '../../../src/document/scene-json/read-scene.ts';
import { distinctCharacters, writeScene } from '../../../src/document/scene-json/write-scene.ts';
import { createActor, emptyScene, sameScene, type Scene } from '../../../src/document/scene.ts';
import { plainView, type ViewState } from '../../../src/document/view-state.ts';
import { characterOfRig } from '../../fixtures/character-of-rig.ts';
import { rotatedTree } from '../../fixtures/rigs.ts';
import { shown } from '../../support/diagnose.ts';
import { randomScene } from '../../support/random-scenes.ts';

const character = characterOfRig(rotatedTree());

const messagesOf = (text: string) => shown(readScene('scene.json', text).diagnostics);

/** The scene that a description gives with the characters of the scene that it was written from. */
function sceneOf(read: SceneDescription, written: Scene): Scene {
  const characters = distinctCharacters(written).map(({ character }) => character);
  const found = (at: number) => {
    const actor = read.actors[at];
    return actor && { id: at + 1, skeleton: characters[actor.character]!.skeleton };
  };
  const actors = read.actors.map((actor, at) => {
    return actorOf(
      actor,
      at + 1,
      characters[actor.character]!,
      read.characters[actor.character]!,
      found,
    );
  });
  return { actors, ...read.surroundings };
}

describe('a scene that is written and read again', () => {
  it('is the same, bit by bit', () => {
    fc.assert(
      fc.property(randomScene, (scene) => {
        const { value, diagnostics } = readScene('scene.json', writeScene(scene));
        const again = sceneOf(value!, scene);
        expect([...diagnostics, ...value!.log.diagnostics]).toEqual([]);
        expect(sameScene(again, scene)).toBe(true);
        expect(writeScene(again)).toBe(writeScene(scene));
      }),
      { numRuns: 60 },
    );
  });

  it('is viewed in the same way', () => {
    const view: ViewState = {
      camera: {
        ...plainView.camera,
        target: [-0, 1 / 3, 5e-324],
        azimuth: 7,
        elevation: -0.5,
        distance: 3,
      },
      workspace: '6.837',
      selected: 3,
      joint: 0,
      signals: {
        ...plainView.signals,
        showSkin: false,
        skeletonStyle: 'boxes',
        showWeights: true,
        weightView: 'sum',
        unlitWeights: true,
        comparison: { ...comparisonOf(['own', 'rigid', 'joint-normals']), base: 1, heatMap: true },
        clipTime: 0.1 + 0.2,
        playMode: 'go on',
      },
    };
    const { value } = readScene('scene.json', writeScene(emptyScene, view));
    expect(sameValue(value!.view, view)).toBe(true);
    expect(readScene('scene.json', writeScene(emptyScene)).value!.view).toBeUndefined();
  });

  it('takes no more room than it needs: what is as it comes is left out', () => {
    expect(writeScene(emptyScene, plainView)).toBe(
      '{"version":1,"characters":[],"actors":[],"view":{}}',
    );
  });
});

describe('an older version', () => {
  it('that compared a kernel with each own one did so side by side', () => {
    const former =
      '{"version":1,"characters":[],"actors":[],"view":{"signals":{"comparedKernel":"rigid"}}}';
    const { value, diagnostics } = readScene('scene.json', former);
    expect(diagnostics).toEqual([]);
    expect(value!.view!.signals.comparison).toEqual({
      ...comparisonOf(['own', 'rigid']),
      layout: 'side by side',
    });
  });

  it('0, the note of early pictures, gives its character in its pose', () => {
    const text = '{"bundled":"tube","name":"Tim","pose":{"joints":{"joint 1":[0,0,0,2]}}}';
    const { value, diagnostics } = readScene('scene.json', text);
    expect(diagnostics).toEqual([]);
    expect(value!.characters).toEqual([{ kind: 'bundled', id: 'tube' }]);
    const actor = actorOf(value!.actors[0]!, 1, character, value!.characters[0]!);
    expect(actor.name).toBe('Tim');
    const [from, to] = jointRange(character.skeleton, character.skeleton.names.indexOf('joint 1'));
    expect([...actor.q.subarray(from, to)]).toEqual([0, 0, 0, 1]);
    expect(value!.log.diagnostics).toEqual([]);
  });
});

describe('what does not fit the character of an actor', () => {
  it.each([
    ['"values":{"joint 1":[0,0,0]}', '4 numbers for "joint 1"'],
    ['"values":{"nobody":[0]}', 'the name of a joint, or # and its index'],
    ['"values":{"joint 7":[1e19]}', 'a value within the limits of "joint 7"'],
    ['"values":[]', 'values by joint'],
    ['"pose":{"joints":{"nobody":[0,0,0]}}', 'the name of a joint, or # and its index'],
    ['"morphs":{"smile":1}', 'the name of a morph, or # and its index'],
    ['"clip":"walk"', 'the name of a clip of the character, or # and its index'],
  ])('is reported, and the actor is as its files have it: %s', (field, message) => {
    const text = `{"version":1,"characters":[{"bundled":"a"}],"actors":[{"character":0,${field}}]}`;
    const { value } = readScene('scene.json', text);
    const actor = actorOf(value!.actors[0]!, 1, character, value!.characters[0]!);
    const plain = createActor(1, character, 'linear-blend', { source: actor.source });
    expect(sameValue(actor, plain)).toBe(true);
    expect(shown(value!.log.diagnostics)).toEqual([expect.stringContaining(message)]);
  });
});

describe('a wrong value', () => {
  const scene = (more: string): string =>
    `{"version":1,"characters":[{"bundled":"tube"}],"actors":[{"character":0}]${more}}`;

  it('affects only itself, and is reported by its path', () => {
    const text = scene(
      ',"environment":{"lights":[{"color":"red"},{"intensity":-1,"azimuth":3},{}]}',
    );
    const { value, diagnostics } = readScene('scene.json', text);
    expect(value!.actors).toHaveLength(1);
    const [first, second] = value!.surroundings.environment.lights;
    expect(first!.color).toBe('#ffffff');
    expect(second).toMatchObject({ intensity: 1, azimuth: 3 });
    expect(shown(diagnostics)).toEqual([
      'error: scene.json:1:109 (environment.lights[0].color): expected a color as "#rrggbb", found ' +
        '""red"" [scene/json]; this part is left out',
      'error: scene.json:1:129 (environment.lights[1].intensity): expected a number from 0 to ' +
        '1000000, found "-1" [scene/json]; this part is left out',
    ]);
  });

  it('of an unknown name is a warning, because a newer Sinew may have written it', () => {
    const { value, diagnostics } = readScene('scene.json', scene(',"fog":{"density":1}'));
    expect(value!.actors).toHaveLength(1);
    expect(shown(diagnostics)).toEqual([expect.stringMatching(/^warning: .*\(fog\)/)]);
  });

  it.each([
    ['', 'found "the end of the text"'],
    ['[]', 'an object with "characters" and "actors"'],
    ['{"actors":[]}', '"characters" to be a list'],
    ['{"version":1,"characters":[],"actors":{}}', '"actors" to be a list'],
    ['{"version":2}', '"version" to be at most 1 (a newer Sinew wrote this)'],
    ['{"version":-1}', '"version" to be a whole number'],
  ])('of the scene itself gives none: %s', (text, message) => {
    expect(readScene('scene.json', text).value).toBeUndefined();
    expect(messagesOf(text)[0]).toContain(message);
  });

  it.each([
    ['{"joints":[{"name":"a","dofs":"XW","values":[1,2]}]}', 'the letters of degrees of freedom'],
    ['{"joints":[{"name":"a","dofs":"XQ","values":[1,2]}]}', 'as many values as "dofs" stands for'],
    ['{"joints":[{"name":"a","dofs":"X","values":["1"]}]}', 'a number from'],
    ['{"morphs":[{"name":"smile","weight":1e40}]}', 'a number from'],
    ['{"height":-1}', 'a number from 0'],
  ])('of a saved pose leaves out that value: %s', (pose, message) => {
    const text = scene(`,"poses":[${pose},{"id":1,"name":"Kept"}]`);
    const { value } = readScene('scene.json', text);
    expect(value!.surroundings.poses.map(({ name }) => name)).toEqual(['Pose', 'Kept']);
    expect(messagesOf(text)[0]).toContain(message);
  });

  it('never throws, whatever the text is', () => {
    const texts = randomScene.map((each) => writeScene(each, plainView));
    fc.assert(
      fc.property(texts, fc.nat(), fc.string({ maxLength: 4 }), (text, at, other) => {
        const place = at % text.length;
        const { value, diagnostics } = readScene(
          'scene.json',
          text.slice(0, place) + other + text.slice(place + other.length),
        );
        expect(value !== undefined || diagnostics.length > 0).toBe(true);
      }),
      { numRuns: 200 },
    );
  });

  it.each([
    ['{"character":1}', 'an index of the 1 characters'],
    ['{"character":-1}', 'a whole number from 0'],
    ['{"character":0,"look":{"clay":8}}', 'a whole number below 8'],
    ['{"character":0,"transform":{"rotation":[0,0,0,2]}}', '4 numbers from -1.001 to 1.001'],
    ['{"character":0,"transform":{"rotation":[0,0,0,0.5]}}', 'a quaternion of length 1'],
    ['{"character":0,"method":"magic"}', 'one of "linear-blend", "rigid"'],
  ])('of an actor: %s', (actor, message) => {
    const text = `{"version":1,"characters":[{"bundled":"tube"}],"actors":[${actor}]}`;
    expect(messagesOf(text)).toEqual([expect.stringContaining(message)]);
  });
});
