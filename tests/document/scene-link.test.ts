import { deflateRawSync, inflateRawSync } from 'node:zlib';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fromBase64url, toBase64url } from '../../src/document/base64url.ts';
import { linkOfScene, sceneOfLink } from '../../src/document/scene-link.ts';

describe('base64url', () => {
  it('is that of Node, and returns the bytes', () => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 40 }), (bytes) => {
        const text = toBase64url(bytes);
        expect(text).toBe(Buffer.from(bytes).toString('base64url'));
        expect(fromBase64url(text)).toEqual(bytes);
      }),
    );
  });

  it.each(['A', 'AB=', 'A B', 'AAAAA', 'AB', 'é', 'A+/A'])('is not %s', (text) => {
    expect(fromBase64url(text)).toBeUndefined();
  });
});

describe('a link', () => {
  it('is the raw Deflate of the text, which comes back', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'grapheme', maxLength: 3000 }), (text) => {
        const hash = linkOfScene(text);
        const packed = Buffer.from(hash.replace('#s=1.', ''), 'base64url');
        expect(inflateRawSync(packed).toString()).toBe(text);
        expect(sceneOfLink(hash)).toEqual({ text });
      }),
    );
  });

  it('of another program is read too', () => {
    const text = '{"actors":[]}';
    const hash = `#s=1.${deflateRawSync(text).toString('base64url')}`;
    expect(sceneOfLink(hash)).toEqual({ text });
  });

  it('that is cut at any place is no link', () => {
    const hash = linkOfScene(JSON.stringify(Array.from({ length: 300 }, (_, i) => i * i)));
    for (let end = 0; end < hash.length; end++) {
      expect(sceneOfLink(hash.slice(0, end)), `${end}`).toHaveProperty('fault');
    }
  });

  it('with other characters says so and never throws', () => {
    const hash = linkOfScene('{"version":1,"characters":[],"actors":[]}');
    fc.assert(
      fc.property(fc.nat(hash.length), fc.string({ maxLength: 3 }), (at, other) => {
        const read = sceneOfLink(hash.slice(0, at) + other + hash.slice(at + other.length));
        expect('text' in read || 'fault' in read).toBe(true);
      }),
    );
  });

  it('of a newer form says so', () => {
    expect(sceneOfLink('#s=2.abc')).toEqual({ fault: 'a newer Sinew made it' });
    expect(sceneOfLink('#s=about')).toEqual({ fault: 'it is not one of a scene' });
  });

  it('that unpacks to very much is refused', () => {
    const bomb = deflateRawSync(Buffer.alloc(4 * 1024 * 1024), { level: 9 });
    const hash = `#s=1.${bomb.toString('base64url')}`;
    expect(sceneOfLink(hash)).toEqual({ fault: 'it is damaged or cut' });
  });
});
