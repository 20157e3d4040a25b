import { describe, expect, it } from 'vitest';
import { readObj } from '../../../src/formats/obj/read-obj.ts';
import { shown } from '../../support/diagnose.ts';
import { bytesOf } from '../../support/files.ts';

async function read(content: string) {
  const { value, diagnostics } = await readObj('a.obj', bytesOf(content));
  return { mesh: value, messages: shown(diagnostics) };
}

const points = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';

async function cornersOf(content: string): Promise<number[]> {
  const { mesh, messages } = await read(content);
  expect(messages).toEqual([]);
  return [...mesh!.cornerPoints];
}

describe('readObj', () => {
  it('reads vertices and triangles in order, used or not, equal or not', async () => {
    const { mesh, messages } = await read('v 1 2 3\nv 1 2 3\nv .5 -1e2 +0\nv 9 9 9\nf 1 2 3\n');
    expect(messages).toEqual([]);
    expect(mesh?.positions).toEqual(Float32Array.of(1, 2, 3, 1, 2, 3, 0.5, -100, 0, 9, 9, 9));
    expect(mesh?.cornerPoints).toEqual(Uint32Array.of(0, 1, 2));
    expect(mesh).not.toHaveProperty('uvs');
    expect(mesh).not.toHaveProperty('normals');
  });

  it('takes a fourth coordinate and colors, and leaves them out', async () => {
    const { mesh, messages } = await read('v 1 2 3 1\nv 4 5 6 .1 .2 .3\nv 7 8 9\nf 1 2 3');
    expect(messages).toEqual([]);
    expect(mesh?.positions).toEqual(Float32Array.of(1, 2, 3, 4, 5, 6, 7, 8, 9));
  });

  it('counts negative indices back from their own line', async () => {
    const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -3 -1\nf 1 2 3';
    expect(await cornersOf(text)).toEqual([0, 1, 2, 0, 1, 3, 0, 1, 2]);
  });

  it('reads corners with texture coordinates and normals, each where it is', async () => {
    const streams = `${points}vt 0 0\nvt 1 0 0\nvt .5\nvn 0 0 1\nvn 0 0 2\n`;
    const { mesh, messages } = await read(`${streams}f 1/1/1 2/2/2 3/3/-1\nf 1//1 -3 -1/-1`);
    expect(messages).toEqual([]);
    expect(mesh?.uvs).toEqual(Float32Array.of(0, 0, 1, 0, 0.5, 0));
    expect(mesh?.normals).toEqual(Float32Array.of(0, 0, 1, 0, 0, 2));
    expect(mesh?.cornerPoints).toEqual(Uint32Array.of(0, 1, 2, 0, 1, 3));
    expect(mesh?.cornerUvs).toEqual(Int32Array.of(0, 1, 2, -1, -1, 2));
    expect(mesh?.cornerNormals).toEqual(Int32Array.of(0, 1, 1, 0, -1, -1));
  });

  it('cuts quads, keeping the way round', async () => {
    expect(await cornersOf(`${points}f 1 2 3 4`)).toEqual([0, 1, 2, 0, 2, 3]);
  });

  it('clips the ears of a face that is not convex, in its place among the others', async () => {
    const dart = 'v 0 0 0\nv 2 0 0\nv .5 .5 0\nv 0 2 0\n';
    const corners = await cornersOf(`${dart}f 1 2 3\nf 1 2 3 4\nf 1 3 4`);
    expect(corners.slice(0, 3)).toEqual([0, 1, 2]);
    expect(corners.slice(-3)).toEqual([0, 2, 3]);
    // From the reflex corner to the opposite one, because the other diagonal is outside.
    expect([corners.slice(3, 6), corners.slice(6, 9)].every((each) => each.includes(2))).toBe(true);
  });

  it('leaves out a material that has only degenerate faces', async () => {
    const { mesh } = await read(`${points}usemtl a\nf 1 1 2\nusemtl b\nf 1 2 3`);
    expect(mesh?.submeshes).toEqual([{ material: 'b', firstTriangle: 0 }]);
  });

  it('joins continued lines and reads over comments', async () => {
    expect(await cornersOf(`# a square\n${points}f 1 2 \\\n  3 4 # all\n`)).toEqual([
      0, 1, 2, 0, 2, 3,
    ]);
  });

  it('keeps material names as they stand, blanks, marks and all', async () => {
    const names = ['dark skin #2', '__proto__', '<img onerror=x>', 'constructor'];
    const text = names.map((name) => `usemtl  ${name} \nf 1 2 3\n`).join('');
    expect((await read(points + text)).mesh?.submeshes).toEqual(
      names.map((material, firstTriangle) => ({ material, firstTriangle })),
    );
    expect((await read(`${points}f 1 2 3\nusemtl b\nf 1 3 4`)).mesh?.submeshes).toEqual([
      { material: '', firstTriangle: 0 },
      { material: 'b', firstTriangle: 1 },
    ]);
  });

  it('says nothing of groups, objects and smoothing', async () => {
    expect(await cornersOf(`o __proto__\n${points}g\ng a b\ns off\ns\ns 1\nf 1 2 3`)).toHaveLength(
      3,
    );
  });

  it('notes each other keyword once, and lines do not disturb the counts', async () => {
    const { mesh, messages } = await read(`${points}l 1\nl 1 2\np 1\nfoo 1 2\nfoo\nf -4 -3 -2\n`);
    expect(mesh?.cornerPoints).toEqual(Uint32Array.of(0, 1, 2));
    const expected = 'expected vertices, texture coordinates, normals and faces, found';
    expect(messages).toEqual([
      `warning: a.obj:5:1: ${expected} "l" [obj/ignored]; such lines are left out`,
      `warning: a.obj:7:1: ${expected} "p" [obj/ignored]; such lines are left out`,
      `warning: a.obj:8:1: ${expected} "foo" [obj/unknown]; such lines are left out`,
    ]);
  });

  it('names a material library and fetches none', async () => {
    const { mesh, messages } = await read(`mtllib ../../secret file.mtl\n${points}f 1 2 3`);
    expect(mesh).toBeDefined();
    expect(messages[0]).toContain('found "mtllib ../../secret file.mtl" [obj/missing]');
  });

  it('leaves out triangles that use a vertex twice, and counts them', async () => {
    const { mesh, messages } = await read(`${points}f 1 1 2\nf 1 2 3\nf 1 2 1\n`);
    expect(mesh?.cornerPoints).toEqual(Uint32Array.of(0, 1, 2));
    expect(messages).toEqual([
      'warning: a.obj: expected triangles of three different vertices, ' +
        'found "2 that are not" [obj/degenerate]; they are left out',
    ]);
  });

  it('leaves out a texture coordinate that is not there, not the face', async () => {
    const { mesh, messages } = await read(`${points}f 1/9 2/9 3/9`);
    expect(mesh?.cornerUvs).toEqual(Int32Array.of(-1, -1, -1));
    expect(messages).toEqual([
      'warning: a.obj:5:3: expected no texture coordinate, as none came before, found "9" ' +
        '[obj/index]; corners whose texture coordinate is not there go without',
    ]);
  });
});
