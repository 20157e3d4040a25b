import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { DiagnosticLog } from '../../../src/core/diagnostics.ts';
import type { JsonValue } from '../../../src/formats/json/decoder.ts';
import { parseJson } from '../../../src/formats/json/parse-json.ts';
import { said } from '../../support/diagnose.ts';

function parsed(text: string, depth?: number) {
  const log = new DiagnosticLog('a.json');
  const json = parseJson(text, { log, area: 'pose', effect: 'nothing is used' }, depth);
  return { json, log, messages: said(log.diagnostics) };
}

function accepts(text: string): boolean {
  try {
    JSON.parse(text);
    return true;
  } catch {
    return false;
  }
}

/** Pieces of JSON texts, so that random texts of them are nearly valid. */
const pieces = ['{', '}', '[', ']', ',', ':', '"', '\\', '"a"', '1', '-', '.5', 'e2', 'true', ' '];

describe('parseJson', () => {
  it('gives the same values as JSON.parse', () => {
    fc.assert(
      fc.property(fc.json({ stringUnit: 'binary' }), (text) => {
        const { json, log } = parsed(text);
        expect(json!.value).toEqual(JSON.parse(text));
        expect(log.diagnostics).toEqual([]);
      }),
    );
    fc.assert(
      fc.property(fc.jsonValue(), fc.constantFrom(0, 1, '\t'), (value, indent) => {
        const text = JSON.stringify(value, null, indent);
        expect(parsed(text).json!.value).toEqual(JSON.parse(text));
      }),
    );
  });

  it('refuses exactly what JSON.parse refuses', () => {
    const texts = fc.oneof(
      fc.string(),
      fc.array(fc.constantFrom(...pieces), { maxLength: 12 }).map((parts) => parts.join('')),
    );
    fc.assert(
      fc.property(texts, (text) => {
        const { json, log } = parsed(text);
        expect(json !== undefined).toBe(accepts(text));
        expect(log.failed).toBe(!accepts(text));
        if (json) expect(json.value).toEqual(JSON.parse(text));
      }),
      { numRuns: 600 },
    );
  });

  it.each([
    ['', '1:1', 'a value', 'the end of the text'],
    [' \n\t', '2:2', 'a value', 'the end of the text'],
    ['[1,\n 2,\n]', '3:1 ([2])', 'a value', ']'],
    ['[1 2]', '1:4', '"," or "]"', '2'],
    ['[1', '1:3', '"," or "]"', 'the end of the text'],
    ['{"a":1,}', '1:8', 'a name in quotes', '}'],
    ['{a:1}', '1:2', 'a name in quotes or "}"', 'a'],
    ['{"a" 1}', '1:6', '":"', '1'],
    ['{"a":1 "b":2}', '1:8', '"," or "}"', '"'],
    ['{"a":}', '1:6 (a)', 'a value', '}'],
    ['{} {}', '1:4', 'the end of the text', '{'],
    ["{'a':1}", '1:2', 'a name in quotes or "}"', "'"],
    ['[01]', '1:2 ([0])', 'a number', '01'],
    ['[1.]', '1:2 ([0])', 'a number', '1.'],
    ['[.5]', '1:2 ([0])', 'a number', '.5'],
    ['[+1]', '1:2 ([0])', 'a number', '+1'],
    ['[1e]', '1:2 ([0])', 'a number', '1e'],
    ['[-]', '1:2 ([0])', 'a value', '-'],
    ['[NaN]', '1:2 ([0])', 'a value', 'NaN'],
    ['nul', '1:1', 'a value', 'nul'],
    ['"a', '1:3', 'a quote at the end of the string', 'the end of the text'],
    ['["a\nb"]', '1:4 ([0])', 'a quote at the end of the string', 'the end of the line'],
    ['"a\\x"', '1:3', '\\ and one of " \\ / b f n r t, or u and four digits', '\\x'],
    ['"\\u12g4"', '1:2', '\\ and one of " \\ / b f n r t, or u and four digits', '\\u'],
    ['[1] // one', '1:5', 'the end of the text', '/'],
    // Columns are counted in bytes, and a byte order mark is not counted.
    ['\uFEFF[é骨🦴]', '1:2 ([0])', 'a value', 'é'],
    ['["é骨🦴" x]', '1:14', '"," or "]"', 'x'],
    ['[1,\r\n2,\r\r\n3,\r4 5]', '4:3', '"," or "]"', '5'],
    ['{"b":[0,{"Left elbow":[1,x]}]}', '1:26 (b[1]."Left elbow"[1])', 'a value', 'x'],
  ])('says where %j is no JSON', (text, place, expected, found) => {
    expect(parsed(text).messages).toEqual([
      `error: a.json:${place}: expected ${expected}, found "${found}" [pose/json]`,
    ]);
  });

  it('shows the line of a fault, or only its start if it is long', () => {
    expect(parsed('[1,\r\n  2 3\r\n]').log.diagnostics).toMatchObject([{ source: '  2 3' }]);
    const [long] = parsed(`["${'a'.repeat(1000)}" 1]`).log.diagnostics;
    expect(long).toMatchObject({ column: 1005, source: `["${'a'.repeat(158)}` });
  });

  it('bounds how deep values nest', () => {
    const nested = (depth: number): string => '['.repeat(depth) + ']'.repeat(depth);
    expect(parsed(nested(1024)).messages).toEqual([]);
    expect(parsed(nested(1025)).messages[0]).toContain('[pose/depth]');
    expect(parsed('[{"a":[[]]}]', 3).messages).toEqual([
      'error: a.json:1:8 ([0].a[0]): expected at most 3 values in one another, found "[" [pose/depth]',
    ]);
    expect(parsed('[[],[],[{}]]', 3).messages).toEqual([]);
    expect(parsed('{"a":'.repeat(1e6)).log.failed).toBe(true);
  });

  it('takes the last value of a repeated name, with a warning', () => {
    const { json, messages } = parsed('{"a": 1, "b": {"c": 1, "c": 2},\n "\\u0061": 3}');
    expect(json!.value).toEqual({ a: 3, b: { c: 2 } });
    expect(messages).toEqual([
      'warning: a.json:1:24 (b.c): expected each name once in an object, found "c" [pose/duplicate]',
      'warning: a.json:2:2 (a): expected each name once in an object, found "a" [pose/duplicate]',
    ]);
  });

  describe('of a long text, whose places are found later', () => {
    const longer = (text: string): string => text + '\n'.repeat(100_000);

    /** The places of all values, in their order. */
    function placesIn(json: JsonValue): readonly unknown[] {
      const { value } = json;
      if (typeof value !== 'object' || value === null) return [json.place];
      const keys = Array.isArray(value) ? [...value.keys()] : Object.keys(value);
      return [json.place, ...keys.map((key) => placesIn(json.member(key)))];
    }

    it('gives the same values, messages and places as of a short one', () => {
      const names = fc.constantFrom('"a"', '"b"', '"\\u0061"', '"a:\\""', '"__proto__"');
      const { value: texts } = fc.letrec<{ value: string }>((tie) => ({
        value: fc.oneof(
          { maxDepth: 4 },
          fc.constantFrom('1', '-0', '"é骨🦴:"', 'true', 'null', '\n2'),
          fc.array(tie('value'), { maxLength: 4 }).map((all) => `[${all.join(',\n')}]`),
          fc
            .array(fc.tuple(names, tie('value')), { maxLength: 4 })
            .map((all) => `{${all.map((pair) => pair.join(': ')).join(', ')}}`),
        ),
      }));
      fc.assert(
        fc.property(texts, (text) => {
          const [short, long] = [parsed(text), parsed(longer(text))];
          expect(long.json!.value).toEqual(short.json!.value);
          expect(long.messages).toEqual(short.messages);
          expect(placesIn(long.json!)).toEqual(placesIn(short.json!));
        }),
      );
    });

    it('refuses the same', () => {
      for (const text of ['{"a":1,}', '[1 2]', '{"a":'.repeat(3000), '['.repeat(1025)]) {
        expect(parsed(longer(text)).messages).toEqual(parsed(text + '\n').messages);
      }
      expect(parsed(longer('[{"a":[[]]}]'), 3).messages[0]).toContain('[pose/depth]');
    });
  });

  it('treats "__proto__" like any other name', () => {
    const value = parsed('{"__proto__": {"a": 1}, "constructor": 2}').json!.value as object;
    expect(Object.getPrototypeOf(value)).toBe(Object.prototype);
    expect(Object.keys(value)).toEqual(['__proto__', 'constructor']);
    expect('a' in value).toBe(false);
  });
});
