import { expect } from '@playwright/test';
import { zipSync } from 'fflate';
import { drop, openSmallView, type NamedFile, verify } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { sharedPage, test } from './support/test.ts';

// These tests drop a character of five joints and sixty points in every way.
const page = sharedPage((page) => openSmallView(page, 'model=tube'));

const [joints, points] = [5, 60];
const whole = { joints, points, problems: [] };

function files(name: string): Record<'skel' | 'obj' | 'attach', NamedFile> {
  const [skel, obj, attach] = madeCharacter(joints, 2).map((file) => ({
    ...file,
    name: file.name.replace('made', name),
  }));
  return { skel: skel!, obj: obj!, attach: attach! };
}

/** What the page shows now, with the expected value of each problem. */
function shown() {
  return page().evaluate(() => {
    const { characters, problems } = window.sinew;
    const [{ name, joints, vertexCount }] = characters as [(typeof characters)[0]];
    return {
      name,
      joints: joints.length,
      points: vertexCount,
      problems: problems.map(({ expected }) => expected),
    };
  });
}

test('a character opens whatever the order and the case of its files', async () => {
  const orders = ['skel obj attach', 'skel attach obj', 'obj skel attach', 'obj attach skel'];
  for (const [index, order] of [...orders, 'attach skel obj', 'attach obj skel'].entries()) {
    const name = `order${index}`;
    const parts = files(name);
    const kinds = order.split(' ') as (keyof typeof parts)[];
    const dropped = kinds.map((kind) => parts[kind]);
    const cased = dropped.map((file, i) => (i === index % 3 ? upper(file) : file));
    await drop(page(), cased);
    const found = await shown();
    expect({ ...found, name: found.name.toLowerCase() }, order).toEqual({ ...whole, name });
    expect(await verify(page())).toMatchObject({ identical: true });
  }
});

function upper({ name, content }: NamedFile): NamedFile {
  return { name: name.toUpperCase(), content };
}

test('incomplete parts are shown, missing files are named, and later drops complete them', async () => {
  const { skel, obj, attach } = files('part');
  await drop(page(), [skel]);
  const bones = { name: 'part', joints, points: 0 };
  expect(await shown()).toEqual({ ...bones, problems: ['part.obj', 'part.attach'] });
  await drop(page(), [obj]);
  expect(await shown()).toEqual({ ...bones, points, problems: ['part.attach'] });
  await drop(page(), [attach]);
  expect(await shown()).toEqual({ ...whole, name: 'part' });
});

test('a mesh without its skeleton and weights is shown and waits for them', async () => {
  const { skel, obj, attach } = files('mesh');
  await drop(page(), [obj]);
  const mesh = { name: 'mesh', joints: 0, points, problems: ['mesh.skel', 'mesh.attach'] };
  expect(await shown()).toEqual(mesh);
  await drop(page(), [skel, attach]);
  expect(await shown()).toEqual({ ...whole, name: 'mesh' });
});

test('weights without a mesh show nothing, and the previous character stays', async () => {
  await drop(page(), Object.values(files('before')));
  await drop(page(), [files('alone').attach]);
  expect(await shown()).toMatchObject({ name: 'before', joints, points });
  expect((await shown()).problems).toEqual(['a .skel and an .obj with it']);
});

test('an archive opens like the files in it', async () => {
  const entries = Object.values(files('packed')).map(
    ({ name, content }) => [`folder/${name}`, Buffer.from(content)] as const,
  );
  await drop(page(), [{ name: 'packed.zip', content: zipSync(Object.fromEntries(entries)) }]);
  expect(await shown()).toEqual({ ...whole, name: 'packed' });
});

test('large files are read by a worker, with the same result', async () => {
  const workers: string[] = [];
  page().on('worker', (worker) => workers.push(worker.url()));
  const { skel, obj, attach } = files('large');
  await drop(page(), [
    skel,
    { ...obj, content: `${'# a comment\n'.repeat(2 ** 17)}${String(obj.content)}` },
    attach,
  ]);
  expect(await shown()).toEqual({ ...whole, name: 'large' });
  expect(workers).toHaveLength(1);
});

test('dropped text, or a drop of nothing, is ignored', async () => {
  const before = await shown();
  const left = await page().evaluate(() => {
    const transfer = new DataTransfer();
    transfer.setData('text/plain', 'a word');
    const event = new DragEvent('drop', {
      dataTransfer: transfer,
      bubbles: true,
      cancelable: true,
    });
    return document.body.dispatchEvent(event);
  });
  expect(left, 'left to the browser').toBe(false);
  expect(await shown()).toEqual(before);
});
