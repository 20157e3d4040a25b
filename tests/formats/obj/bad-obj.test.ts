import { describe, expect, it } from 'vitest';
import { defaultLimits } from '../../../src/core/limits.ts';
import { readObj } from '../../../src/formats/obj/read-obj.ts';
import { shown } from '../../support/diagnose.ts';
import { bytesOf } from '../../support/files.ts';

const points = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';
const corner = 'expected a corner "v", "v/vt", "v//vn" or "v/vt/vn"';
const range = 'expected 1 to 4 or -4 to -1';

describe('readObj refuses', () => {
  it.each([
    ['v 1 2', ':5: expected 3 numbers, found "2" [obj/field-count]'],
    ['v x 0 0', ':5:3: expected a number for x, found "x" [obj/number]'],
    ['v 0 0 1e39', ':5:7: expected z within ±1e18, found "1e39" [obj/range]'],
    ['vn 0 1', ':5: expected 3 numbers, found "2" [obj/field-count]'],
    ['f 0 1 2', `:5:3: ${range}, found "0" [obj/index]`],
    ['f 1 2 9', `:5:7: ${range}, found "9" [obj/index]`],
    ['f -1 -2 -9', `:5:9: ${range}, found "-9" [obj/index]`],
    ['f 4294967297 2 3', `:5:3: ${range}, found "4294967297" [obj/index]`],
    ['f 1 2 5\nv 0 0 1', `:5:7: ${range}; vertex 5 comes later, in line 6, found "5" [obj/index]`],
    ['f 1/2/3/4 2 3', `:5:3: ${corner}, found "1/2/3/4" [obj/face]`],
    ['f /1 2 3', `:5:3: ${corner}, found "/1" [obj/face]`],
    ['f a/b/c 2 3', `:5:3: ${corner}, found "a/b/c" [obj/face]`],
    ['f 1.5 2 3', `:5:3: ${corner}, found "1.5" [obj/face]`],
    ['f 1e0 2 3', `:5:3: ${corner}, found "1e0" [obj/face]`],
    ['f 0x1 2 3', `:5:3: ${corner}, found "0x1" [obj/face]`],
  ])('%j', async (line, message) => {
    const { value, diagnostics } = await readObj('a.obj', bytesOf(`${points}${line}\nf 1 2 3\n`));
    expect(value).toBeUndefined();
    expect(shown(diagnostics)).toEqual([`error: a.obj${message}; the mesh is not used`]);
  });

  it.each([
    ['# nothing\n', 'expected at least one vertex, found "none"'],
    [points, 'expected at least one triangle, found "none"'],
    [`${points}f 1 1 2`, 'expected at least one triangle, found "none"'],
  ])('%j, which has no surface', async (text, message) => {
    const { value, diagnostics } = await readObj('a.obj', bytesOf(text));
    expect(value).toBeUndefined();
    expect(shown(diagnostics)[0]).toBe(
      `error: a.obj: ${message} [obj/empty]; the mesh is not used`,
    );
  });
});

describe('the limits of readObj', () => {
  it.each([
    ['pointCount', 4, `${points}f 1 2 3`, 'at most 3 vertices'],
    ['triangleCount', 3, `${points}f 1 2 3\nf 1 2 3\nf 1 2 3\n`, 'at most 2 triangles'],
    ['triangleCount', 2, `${points}f 1 2 3 4`, 'at most 1 triangles'],
    ['cornersPerFace', 4, `${points}f 1 2 3 4`, 'a face of at most 3 corners'],
  ])('%s: %d are taken, one more than the limit is not', async (name, count, text, expected) => {
    const readWith = (limit: number) =>
      readObj('a.obj', bytesOf(text), { ...defaultLimits, [name]: limit });
    expect(await readWith(count)).toMatchObject({ value: { file: 'a.obj' }, diagnostics: [] });
    const beyond = await readWith(count - 1);
    expect(beyond.value).toBeUndefined();
    expect(beyond.diagnostics).toMatchObject([{ code: 'obj/limit', expected }]);
  });

  it('list a hundred bad faces and count the rest', async () => {
    const { diagnostics } = await readObj('a.obj', bytesOf(`${points}${'f 1 2 x\n'.repeat(300)}`));
    expect(diagnostics).toHaveLength(101);
    expect(diagnostics.at(-1)).toMatchObject({ code: 'file/more', found: '200 more' });
  });
});
