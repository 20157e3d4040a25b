import { describe, expect, it } from 'vitest';
import { buffersOf } from '../../src/core/buffers-of.ts';

describe('buffersOf', () => {
  it('finds every buffer once, however deep and however often', () => {
    const shared = new Float32Array(8);
    const own = Uint8Array.of(1, 2, 3);
    const value = {
      text: 'a',
      nothing: null,
      missing: undefined,
      number: 1,
      list: [shared.subarray(0, 4), { deep: [[shared.subarray(4)], own] }],
      view: new DataView(own.buffer),
    };
    expect(buffersOf(value)).toEqual([shared.buffer, own.buffer]);
    expect(new Set(buffersOf(value))).toEqual(new Set([shared.buffer, own.buffer]));
  });

  it('leaves out buffers that are shared between threads, which need no transfer', () => {
    expect(buffersOf([new Uint8Array(new SharedArrayBuffer(4))])).toEqual([]);
  });

  it.each([[null], [undefined], [1], ['text'], [[]], [{}]])('finds none in %j', (value) => {
    expect(buffersOf(value)).toEqual([]);
  });

  it('gives what structuredClone can transfer', () => {
    const value = { a: Float32Array.of(1, 2), b: [Uint16Array.of(3)] };
    const clone = structuredClone(value, { transfer: buffersOf(value) });
    expect(clone).toEqual({ a: Float32Array.of(1, 2), b: [Uint16Array.of(3)] });
    expect(value.a).toHaveLength(0);
  });
});
