import { describe, expect, it } from 'vitest';
import { DiagnosticLog } from '../../../src/core/diagnostics.ts';
import { checkVersion, type JsonValue } from '../../../src/formats/json/decoder.ts';
import { parseJson } from '../../../src/formats/json/parse-json.ts';
import { shown } from '../../support/diagnose.ts';

function decode(text: string, read: (json: JsonValue) => unknown) {
  const log = new DiagnosticLog('a.json');
  const json = parseJson(text, { log, area: 'pose', effect: 'nothing is used' })!;
  return { read: read(json), messages: shown(log.diagnostics) };
}

const versionOf = (text: string) => decode(text, (json) => checkVersion(json.record('an object')!));

describe('a version', () => {
  it.each(['{}', '{"version": 1}', '{"version": 1.0}'])('is 1 in %s', (text) => {
    expect(versionOf(text)).toEqual({ read: true, messages: [] });
  });

  it('that is newer is reported as newer', () => {
    expect(versionOf('{"version": 2}')).toEqual({
      read: false,
      messages: [
        'error: a.json:1:13 (version): expected "version" to be 1 (a newer Sinew wrote this), ' +
          'found "2" [pose/version]; nothing is used',
      ],
    });
  });

  it.each(['0', '-1', '"1"', 'null', '[1]'])('%s is none', (version) => {
    const { read, messages } = versionOf(`{"version": ${version}}`);
    expect(read).toBe(false);
    expect(messages[0]).toContain('(version): expected "version" to be 1, found');
  });
});

describe('values of a shape', () => {
  it('are given as they are', () => {
    expect(decode('[1, -2.5]', (json) => json.numbers([2, 3], 'two')).read).toEqual([1, -2.5]);
    expect(decode('"a"', (json) => json.text('a text')).read).toBe('a');
    const names = decode('{"a": 1, "__proto__": 2}', (json) => [...json.record('')!.keys()]);
    expect(names.read).toEqual(['a', '__proto__']);
  });

  it.each([
    ['[1, 2]', ':1:1', '[1,2]'],
    ['[1,\n null, 3]', ':2:2 ([1])', '[1,null,3]'],
    ['[1, 2, [3]]', ':1:8 ([2])', '[1,2,[3]]'],
    ['{"0": 1}', ':1:1', '{"0":1}'],
  ])('are told apart from others: %j is not three numbers', (text, place, found) => {
    expect(decode(text, (json) => json.numbers([3], 'three numbers'))).toEqual({
      read: undefined,
      messages: [
        `error: a.json${place}: expected three numbers, found "${found}" [pose/json]; nothing is used`,
      ],
    });
  });

  it('report the place of an error, whatever the order of access', () => {
    const { messages } = decode('{"é": [1,\n2], "b": 3}', (json) => {
      json.member('b').text('a text');
      json.member('é').member(0).text('a text');
    });
    const expected = 'expected a text, found';
    expect(messages).toEqual([
      `error: a.json:2:10 (b): ${expected} "3" [pose/json]; nothing is used`,
      `error: a.json:1:9 ("é"[0]): ${expected} "1" [pose/json]; nothing is used`,
    ]);
  });
});
