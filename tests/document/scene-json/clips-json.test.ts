import { describe, expect, it } from 'vitest';
import { sameValue } from '../../../src/core/same-value.ts';
import { actorOf } from '../../../src/document/scene-json/actor-json.ts';
import { readScene } from '../../../src/document/scene-json/read-scene.ts';
import { writeScene } from '../../../src/document/scene-json/write-scene.ts';
import { createActor, emptyScene } from '../../../src/document/scene.ts';
import { characterOfRig } from '../../fixtures/character-of-rig.ts';
import { rotatedTree } from '../../fixtures/rigs.ts';
import { shown } from '../../support/diagnose.ts';

const plain = characterOfRig(rotatedTree());
const clip = { file: 'walk.anim', start: 0, end: 1, fps: 30, channels: [] };
const character = {
  ...plain,
  clips: [
    { ...clip, name: 'walk' },
    { ...clip, name: 'wave' },
  ],
};

const source = { kind: 'bundled', id: 'a' } as const;

function read(fields: string) {
  const text = `{"version":1,"characters":[{"bundled":"a"}],"actors":[{"character":0,${fields}}]}`;
  const { value } = readScene('scene.json', text);
  const actor = actorOf(value!.actors[0]!, 1, character, source);
  return { actor, messages: shown(value!.log.diagnostics) };
}

const channel = (more: string): string =>
  `"clips":[{"name":"own","end":2,"channels":[{${more}},{"target":null,"keys":[]}]}]`;

const target = '"target":{"joint":"joint 7","value":"rx"}';

describe('clips of a scene', () => {
  it('are not written while they are those of the files', () => {
    const actor = createActor(1, character, 'linear-blend', { source, clip: 1 });
    const text = writeScene({ ...emptyScene, actors: [actor] });
    expect(text).toContain('"clip":"wave"');
    expect(text).not.toContain('"clips"');
  });

  it('are written by their names where the files have them, others with all their keys', () => {
    const [walk, wave] = character.clips;
    const clips = [wave!, { ...walk!, name: 'stroll' }];
    const actor = createActor(1, character, 'linear-blend', { source, clips, clip: 1 });
    const text = writeScene({ ...emptyScene, actors: [actor] });
    expect(text).toContain(
      '"clips":["wave",{"file":"walk.anim","name":"stroll","start":0,"end":1,"fps":30,"channels":[]}],"clip":"stroll"',
    );
  });

  it('keep the bound one although one before it is missing', () => {
    const { actor, messages } = read('"clips":["run","wave","walk","walk"],"clip":"#2"');
    expect(actor.clips).toEqual([character.clips[1], character.clips[0], character.clips[0]]);
    expect(actor.clip).toBe(1);
    expect(messages).toEqual([expect.stringContaining('the name of a clip of the character')]);
  });

  it.each([
    ['"target":{"joint":"nobody","value":"rx"},"keys":[]', 'the name of a joint'],
    ['"target":{"joint":"joint 7","value":"sx"},"keys":[]', 'one of tx, ty'],
    ['"target":{"joint":"joint 7","rotation":"nlerp"},"keys":[]', 'one of slerp, squad'],
    ['"target":{"morph":"smile"},"keys":[]', 'the name of a morph, or # and its index'],
    ['"target":{"pin":"joint 7","value":"w"},"keys":[]', 'one of x, y, z, weight'],
    ['"target":{},"keys":[]', 'a target as MOTION.json has it'],
    ['"target":7,"keys":[]', 'what the channel moves'],
    [target, 'a list of keys'],
    [`${target},"keys":[[0,0],[0,1]]`, 'a time after that of the key before'],
    [`${target},"keys":[[0]]`, 'a number from'],
    [`${target},"keys":[[0,1e19]]`, 'a number from'],
    [`${target},"keys":[[0,0,"soft"]]`, 'one of "flat", "linear"'],
    [`${target},"keys":[[0,0,["tcb",0,0]]]`, '["tcb", T, C, B]'],
    [`${target},"keys":[[0,0,["tcb",0,0,"a"]]]`, 'a number from'],
    [`${target},"keys":[],"extrapolate":["cycle"]`, 'the rules before and after the keys'],
    [`${target},"keys":[],"extrapolate":["cycle","jump"]`, 'one of "constant", "linear"'],
    [
      '"target":{"joint":"joint 7","rotation":"slerp"},"keys":[[0,[0,0,0,2]]]',
      '4 numbers from -1.001 to 1.001',
    ],
    ['"target":{"joint":"joint 7","rotation":"slerp"},"keys":[[0,1]]', '4 numbers from'],
  ])('lose only a channel that is wrong: %s', (bad, message) => {
    const { actor, messages } = read(channel(bad));
    const rest = { target: null, before: 'constant', after: 'constant', keys: [] };
    const own = { file: '', name: 'own', start: 0, end: 2, fps: 30, channels: [rest] };
    expect(sameValue(actor.clips, [own])).toBe(true);
    expect(messages).toEqual([expect.stringContaining(message)]);
  });

  it('have one channel for each value', () => {
    const one = `{${target},"keys":[[0,1]]}`;
    const { actor, messages } = read(`"clips":[{"channels":[${one},${one}]}]`);
    expect(actor.clips[0]!.channels.length).toBe(1);
    expect(messages).toEqual([expect.stringContaining('one channel for each value')]);
  });

  it.each([
    ['"clips":7', 'a list of at most 10000 clips', 2],
    ['"clips":[{"start":1,"end":0,"channels":[]},"walk"]', 'an end that is not before', 1],
    ['"clips":[7,"walk"]', 'an object', 1],
  ])('that are none are reported: %s', (fields, message, count) => {
    const { actor, messages } = read(fields);
    expect(actor.clips.length).toBe(count);
    expect(messages).toEqual([expect.stringContaining(message)]);
  });

  it.each([
    ['{"values":{}}', 'a number from'],
    ['{"time":1,"values":{"nobody":[0]}}', 'the name of a joint'],
    ['{"time":1,"values":{"joint 7":[99]}}', 'an index of the 1 values'],
    ['{"time":1,"morphs":["smile"]}', 'the name of a morph'],
    ['{"time":1,"pins":["joint 7"]}', 'the name of a pinned joint'],
  ])('are followed by what is unkeyed, as far as it is there: %s', (unkeyed, message) => {
    const { actor, messages } = read(`"unkeyed":${unkeyed}`);
    expect([null, 1]).toContain(actor.unkeyed?.time ?? null);
    expect(actor.unkeyed?.values ?? []).toEqual([]);
    expect(messages).toEqual([expect.stringContaining(message)]);
  });
});
