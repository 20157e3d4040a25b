import { gzipSync } from 'node:zlib';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Failure } from '../../src/core/failure.ts';
import { fetchFile } from '../../src/app/fetch-file.ts';

const origin = 'http://page.test';
const fetched = vi.fn<typeof fetch>();

beforeEach(() => {
  vi.stubGlobal('location', { origin });
  vi.stubGlobal('fetch', fetched);
});

afterEach(() => {
  vi.unstubAllGlobals();
  fetched.mockReset();
});

const answer = (body: Uint8Array | ReadableStream | string, status = 200): void => {
  fetched.mockResolvedValue(new Response(body as BodyInit, { status }));
};
const fileAt = (path: string, limit?: number) =>
  fetchFile(new URL(path, `${origin}/`), undefined, limit);
const messageOf = (path: string, limit?: number): Promise<string> =>
  fileAt(path, limit).then(
    () => 'no error',
    (error: unknown) => (error instanceof Failure ? error.message : `not told: ${String(error)}`),
  );

/** A stream of this many bytes, one by one, which counts how many were requested. */
function slowly(count: number): { stream: ReadableStream; asked: () => number } {
  let given = 0;
  const stream = new ReadableStream({
    pull(controller) {
      if (given++ < count) controller.enqueue(Uint8Array.of(7));
      else controller.close();
    },
  });
  return { stream, asked: () => given };
}

describe('fetchFile', () => {
  it('gives the unpacked bytes under the name of the file', async () => {
    answer('v 0 0 0\n');
    expect((await fileAt('data/a%20b.obj')).path).toBe('a b.obj');
    answer(gzipSync('v 1 2 3\n'));
    const file = await fileAt('data/b.obj.gz');
    expect([file.path, new TextDecoder().decode(file.bytes)]).toEqual(['b.obj', 'v 1 2 3\n']);
  });

  it.each([
    'https://elsewhere.test/a.obj',
    'http://page.test.elsewhere.test/a.obj',
    'https://page.test/a.obj',
    'http://page.test:81/a.obj',
    'blob:http://page.test/0-1-2',
    'data:text/plain,v 0 0 0',
    'file:///a.obj',
  ])('asks nothing of %s', async (url) => {
    expect(await messageOf(url)).toMatch(/page's own server; download it and drop it here$/);
    expect(fetched).not.toHaveBeenCalled();
  });

  it('follows no redirect', async () => {
    answer('');
    await fileAt('a.obj');
    expect(fetched.mock.calls[0]![1]).toMatchObject({ redirect: 'error' });
  });

  it('accepts as many bytes as the limit, and requests no more', async () => {
    answer(slowly(10).stream);
    expect((await fileAt('a.obj', 10)).bytes.length).toBe(10);
    const endless = slowly(1e9);
    answer(endless.stream);
    expect(await messageOf('a.obj', 10)).toBe('/a.obj has more than 10 bytes');
    expect(endless.asked()).toBeLessThan(20);
  });

  it('unpacks as many bytes as the limit', async () => {
    answer(gzipSync(new Uint8Array(1000)));
    expect((await fileAt('a.obj.gz', 1000)).bytes.length).toBe(1000);
    answer(gzipSync(new Uint8Array(1001)));
    expect(await messageOf('a.obj.gz', 1000)).toBe('/a.obj.gz has more than 1000 bytes');
  });

  it('reports the server’s status, interrupted transfers and damaged data', async () => {
    answer('gone', 404);
    expect(await messageOf('a.obj')).toBe('/a.obj: the server says 404');
    fetched.mockRejectedValue(new TypeError('Failed to fetch'));
    expect(await messageOf('a.obj')).toBe('/a.obj could not be fetched');
    answer(
      new ReadableStream({
        pull: (controller) => controller.error(new TypeError('network error')),
      }),
    );
    expect(await messageOf('a.obj')).toBe('/a.obj broke off, or is damaged');
    answer(gzipSync(new Uint8Array(1000)).subarray(0, 15));
    expect(await messageOf('a.obj.gz')).toBe('/a.obj.gz broke off, or is damaged');
  });
});
