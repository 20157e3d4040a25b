import { describe, expect, it } from 'vitest';
import type { Mesh } from '../../src/core/mesh.ts';
import { emptyMesh } from '../../src/core/mesh.ts';
import { noJoint, type Skin } from '../../src/core/skin.ts';
import { packAffinePalette } from '../../src/skinning/affine-palette.ts';
import { flushSubnormal } from '../../src/core/float32.ts';
import { kernelById, kernelNamed, kernels } from '../../src/skinning/registry.ts';
import { loadedKernels } from '../support/kernels.ts';
import { identity, type Matrix, translation } from '../reference/matrix.ts';
import { columnMajor } from '../support/compare.ts';
import { useOf } from '../support/method-use.ts';
import type { KernelId } from '../../src/skinning/method.ts';

/** One vertex that follows one palette entry, whose matrix is the given one in every pose. */
function oneVertex(position: readonly number[], normal: readonly number[], bind: Matrix) {
  const mesh: Mesh = {
    ...emptyMesh,
    pointCount: 1,
    vertexCount: 1,
    pointOf: Uint32Array.of(0),
    positions: Float32Array.from(position),
    normals: Float32Array.from(normal),
  };
  const skin: Skin = {
    paletteJoint: Uint16Array.of(noJoint),
    jointFromBind: Float64Array.from(columnMajor(bind)),
    start: Uint32Array.of(0, 1),
    entries: Uint16Array.of(0),
    weights: Float32Array.of(1),
    normals: 'blended',
  };
  return { mesh, skin };
}

describe.each(loadedKernels)('the strict kernel of $id', (method) => {
  function move(position: readonly number[], normal: readonly number[], bind: Matrix) {
    const { mesh, skin } = oneVertex(position, normal, bind);
    const palette = new Float32Array(method.vec4sPerEntry(skin) * 4);
    method.packPalette(skin, new Float64Array(0), palette);
    const out = { positions: new Float32Array(3), normals: new Float32Array(3) };
    method.deform(mesh, skin, palette, out, useOf(method, mesh, skin));
    return { position: [...out.positions], normal: [...out.normals] };
  }

  it('flushes subnormal positions and normals to +0', () => {
    const { position, normal } = move([1e-39, -1e-40, 0.5], [1, 1e-39, -1e-39], identity);
    expect(position).toEqual([0, 0, 0.5]);
    expect(normal).toEqual([1, 0, 0]);
  });

  it('keeps a mirrored normal pointing outwards', () => {
    const mirror: Matrix = [[-1, 0, 0, 0], ...identity.slice(1)];
    expect(move([1, 0, 0], [1, 0, 0], mirror)).toEqual({
      position: [-1, 0, 0],
      normal: [-1, 0, 0],
    });
    expect(move([0, 1, 0], [0, 1, 0], mirror).normal).toEqual([0, 1, 0]);
  });

  it('keeps a normal upright on a stretched surface', () => {
    const stretch: Matrix = [[2, 0, 0, 0], ...identity.slice(1)];
    const { normal } = move([0, 0, 0], [Math.SQRT1_2, Math.SQRT1_2, 0], stretch);
    expect(normal[0]! / normal[1]!).toBeCloseTo(0.5, 6);
    expect(Math.hypot(...normal)).toBeCloseTo(1, 6);
  });

  it('gives +y for a normal that is flattened to zero', () => {
    // Cofactors of 1e-24, or a matrix without an inverse.
    const least = method.id === 'joint-normals' ? 0 : 1e-12;
    const crush = identity.map((row, r) => row.map((one) => (r < 3 ? one * least : one)));
    expect(move([1, 2, 3], [1, 0, 0], crush).normal).toEqual([0, 1, 0]);
  });
});

describe('packAffinePalette', () => {
  it('rounds the product once, from float64', () => {
    // In float32, (1e8 + 1) − 1e8 would be 0.
    const { skin } = oneVertex([0, 0, 0], [0, 1, 0], translation([-1e8, 1e-39, 0.1]));
    const world = Float64Array.from(columnMajor(translation([1e8 + 1, 0, 0.2])));
    const palette = new Float32Array(12);
    packAffinePalette({ ...skin, paletteJoint: Uint16Array.of(0) }, world, palette);
    const third = Math.fround(0.1 + 0.2);
    expect([...palette]).toEqual([1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, third]);
  });
});

describe('flushSubnormal', () => {
  it('keeps the numbers that a GPU keeps', () => {
    expect([1.3e-38, -1.3e-38, 1].map(flushSubnormal)).toEqual([1.3e-38, -1.3e-38, 1]);
    expect([1.1e-38, -1e-45, -0].map(flushSubnormal)).toEqual([0, 0, 0]);
  });
});

describe('the registry of methods', () => {
  it('has the default first and no id twice', () => {
    expect(kernels[0]!.id).toBe('linear-blend');
    expect(new Set(kernels.map(({ id }) => id)).size).toBe(kernels.length);
    for (const kernel of kernels) expect(kernelById(kernel.id)).toBe(kernel);
    expect(loadedKernels.map(({ id }) => id)).toEqual(kernels.map(({ id }) => id));
  });

  it('does not accept other names', () => {
    expect(kernelNamed('lbs')).toBe(kernelNamed('linear-blend'));
    expect(kernelNamed('rigid')).toBe(kernelById('rigid'));
    expect(kernelNamed('constructor')).toBeUndefined();
    expect(() => kernelById('constructor' as KernelId)).toThrow('a skinning kernel named');
  });
});
