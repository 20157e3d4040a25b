import { describe, expect, it } from 'vitest';
import { readPictureNote } from '../../src/app/read-picture-note.ts';
import { decodePose } from '../../src/formats/pose-json.ts';
import { courseSkel } from '../support/course-skeleton.ts';
import { shown } from '../support/diagnose.ts';
import { readOne } from '../support/files.ts';

const { skeleton } = await readOne({ 'a.skel': courseSkel });

const read = (text: string) => readPictureNote({ path: 'a.png', text });

describe('readPictureNote', () => {
  it('reads what was written', () => {
    const pose = { joints: { Neck: [0, 1, 0] as [number, number, number] } };
    const {
      bundled,
      pose: json,
      log,
    } = read(JSON.stringify({ bundled: 'tube', name: 'Tube', pose }));
    expect(bundled).toBe('tube');
    expect([...decodePose(json!, skeleton).value!.q].filter((value) => value !== 0)).toEqual([1]);
    expect(log.diagnostics).toEqual([]);
    expect(read(JSON.stringify({ name: 'my own', pose: {} })).bundled).toBeUndefined();
  });

  it.each([
    ['', ':1:1', 'a value, found "the end of the text" [pose/json]'],
    [
      '{"name":"a","pose":{',
      ':1:21 (pose)',
      'a name in quotes or "}", found "the end of the text" [pose/json]',
    ],
    ['null', ':1:1', 'an object with "name" and "pose", found "null" [pose/json]'],
    ['{"pose":{}}', ':1:1 (name)', '"name" to be a text, found "undefined" [pose/json]'],
    ['{"name":"a"}', ':1:1 (pose)', '"pose" to be an object, found "undefined" [pose/json]'],
    ['{"name":"a","pose":[]}', ':1:20 (pose)', '"pose" to be an object, found "[]" [pose/json]'],
    [
      '{"bundled":7,"name":"a","pose":{}}',
      ':1:12 (bundled)',
      '"bundled" to be the id of a character, found "7" [pose/json]',
    ],
    [
      '{"version":3}',
      ':1:12 (version)',
      '"version" to be 1 (a newer Sinew wrote this), found "3" [pose/version]',
    ],
  ])('says what is wrong with %s', (text, place, message) => {
    const { pose, bundled, log } = read(text);
    expect([pose, bundled]).toEqual([undefined, undefined]);
    expect(shown(log.diagnostics)).toEqual([
      `error: a.png${place}: expected ${message}; the pose of the picture is not used`,
    ]);
  });

  it('reports the problems of a pose at the same places', () => {
    const { pose, log } = read('{"name":"a","pose":{"joints":{"Neck":[0,true,0]}}}');
    expect(decodePose(pose!, skeleton).value).toBeUndefined();
    expect(shown(log.diagnostics)).toEqual([
      'error: a.png:1:41 (pose.joints.Neck[1]): expected three numbers for "Neck", ' +
        'found "[0,true,0]" [pose/json]; the pose of the picture is not used',
    ]);
  });
});
