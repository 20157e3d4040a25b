import { describe, expect, it } from 'vitest';
import { FileOpener } from '../../src/app/open-files.ts';
import { openOwnFiles } from '../../src/app/open-own-files.ts';
import { pictureKeyword } from '../../src/app/picture-note.ts';
import { bindClip } from '../../src/document/edits.ts';
import { openCharacters } from '../../src/document/open-characters.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import type { Source } from '../../src/document/scene.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { memoryFile } from '../../src/formats/file-entry.ts';
import type { FileEntry } from '../../src/formats/format.ts';
import type { ReadCharacter } from '../../src/formats/read-characters.ts';
import { insertPngText } from '../../src/formats/png/text-chunk.ts';
import { leg, legAnim, legSkel } from '../support/cse169-files.ts';
import { courseSkel } from '../support/course-skeleton.ts';
import { bytesOf, type FileContents, readOne } from '../support/files.ts';

async function open(source: Source = { kind: 'files', files: [] }) {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  const opener = new FileOpener(store, session, new Evaluations(store, session), () => ({}));
  const character = await readOne({ 'a.skel': courseSkel });
  const first = { character, method: 'linear-blend', kept: { source } } as const;
  store.dispatch(openCharacters([], source.kind === 'bundled' ? [first, first] : [first]));
  const [scene, problems] = [store.scene.value, session.problems.value];
  const current = new AbortController();
  const aborted = (): void => current.abort();
  const run = (
    files: readonly FileEntry[],
    openBundled = () => Promise.resolve(),
    way: Pick<Parameters<typeof openOwnFiles>[2], 'add' | 'ask'> = { add: false },
  ) =>
    openOwnFiles(opener, files, {
      signal: current.signal,
      onProgress: () => undefined,
      openBundled,
      ...way,
    });
  const asItWas = (): boolean => store.scene.value === scene && session.problems.value === problems;
  return { session, store, run, aborted, asItWas };
}

/** The parts of a PNG that Sinew reads: its signature, the note and its end. */
function picture(bundled: string): FileEntry {
  const empty = Uint8Array.from([
    137,
    80,
    78,
    71,
    13,
    10,
    26,
    10,
    ...new Array<number>(12).fill(0),
  ]);
  const note = JSON.stringify({ bundled, name: 'Any', pose: { joints: { '#0': [1, 0, 0] } } });
  return memoryFile('picture.png', insertPngText(empty, pictureKeyword, note));
}

describe('an opening that another one replaced', () => {
  it('leaves pose and problems alone, wherever it was waiting', async () => {
    const waits: Record<
      string,
      (aborted: () => void) => Parameters<Awaited<ReturnType<typeof open>>['run']>
    > = {
      'for the character of a picture': (aborted) => [
        [picture('dog')],
        () => Promise.resolve().then(aborted),
      ],
      'for the bytes of a pose': (aborted) => [[slow('a.json', '{"joints":{}, "x":', aborted)]],
      'for the bytes of a character': (aborted) => [[slow('b.skel', courseSkel, aborted)]],
    };
    for (const [wait, make] of Object.entries(waits)) {
      const { run, aborted, asItWas } = await open();
      expect(await run(...make(aborted)), wait).toBeUndefined();
      expect(asItWas(), wait).toBe(true);
    }
  });
});

function slow(path: string, content: string, meanwhile: () => void): FileEntry {
  const file = memoryFile(path, bytesOf(content));
  return {
    ...file,
    bytes: () =>
      Promise.resolve()
        .then(meanwhile)
        .then(() => file.bytes()),
  };
}

describe('files that can’t be read', () => {
  it.each(['pose.json', 'picture.png', 'a.obj', 'notes.txt'])('are reported: %s', async (path) => {
    const { session, run } = await open();
    const fault = new DOMException('a text of the browser', 'NotReadableError');
    const broken = { ...memoryFile(path, bytesOf('')), bytes: () => Promise.reject(fault) };
    const whole = memoryFile('b.skel', bytesOf(courseSkel));
    expect((await run([broken, whole]))?.opened?.name).toBe('b');
    const told = session.problems.value.filter(({ file }) => file === path);
    expect(told).toHaveLength(1);
  });
});

describe('a skeleton alone', () => {
  it('is seen, and moves by its .anim and by a motion that comes later', async () => {
    const session = new Session();
    const store = new Store((before, after) => reconcile(session, before, after));
    const evaluations = new Evaluations(store, session);
    const opener = new FileOpener(store, session, evaluations, () => ({}));
    const drop = (contents: FileContents) =>
      openOwnFiles(
        opener,
        Object.entries(contents).map(([name, text]) => memoryFile(name, bytesOf(text))),
        {
          signal: new AbortController().signal,
          onProgress: () => undefined,
          openBundled: () => Promise.resolve(),
          add: false,
        },
      );
    await drop({ 'leg.skel': legSkel, 'leg_walk.anim': legAnim });
    expect(session.showSkeleton.value).toBe(true);
    const kneeAt = (time: number): number[] => {
      session.clipTime.value = time;
      const shown = evaluations.selected()!;
      const { skeleton } = shown.state.character;
      return [...shown.snapshot().q.subarray(skeleton.dofQ[skeleton.dofStart[1]!])].slice(0, 3);
    };
    store.amend(bindClip(opener.selected!.id, 0));
    await evaluations.settled();
    // x, y and z of the knee in the .anim, whose other channels move the root.
    expect(kneeAt(0.5)).toEqual([0.25, 0.25, 0.25]);
    const keys = [
      [0, 0],
      [1, 0.5],
    ];
    const motion = { channels: [{ target: { joint: 'knee', value: 'rx' }, keys }] };
    await drop({ 'bend.motion.json': JSON.stringify(motion) });
    expect(opener.selected!.clips.map(({ name }) => name)).toEqual(['leg_walk', 'bend']);
    expect(session.problems.value).toEqual([]);
    await evaluations.settled();
    expect([0, 0.5].map((time) => kneeAt(time)[2])).toEqual([0, 0.25]);
  });
});

describe('where opened files go', () => {
  /** Opens the files, with an answer to the question, and returns what was asked and what is open. */
  async function openWith(answer: boolean | null, ...contents: readonly FileContents[]) {
    const { run, store } = await open();
    const asked: string[] = [];
    const ask = (found: readonly ReadCharacter[]): Promise<boolean | null> => {
      asked.push(found.map(({ character }) => character.name).join());
      return Promise.resolve(answer);
    };
    for (const each of contents) {
      const files = Object.entries(each).map(([name, text]) => memoryFile(name, bytesOf(text)));
      await run(files, undefined, { add: false, ask });
    }
    return { asked, names: store.scene.value.actors.map(({ character }) => character.name) };
  }

  const another = { 'b.skel': courseSkel };

  it('is asked about other characters, and the answer holds', async () => {
    expect(await openWith(true, another)).toEqual({ asked: ['b'], names: ['a', 'b'] });
    expect(await openWith(false, another)).toEqual({ asked: ['b'], names: ['b'] });
    expect(await openWith(null, another)).toEqual({ asked: ['b'], names: ['a'] });
  });

  it('is not asked about poses and clips, nor about files that complete or update what is open', async () => {
    const mesh = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
    const own: readonly FileContents[] = [
      another,
      { 'b.pose.json': '{"joints":{}}' },
      { 'b.obj': mesh },
      { 'b.skel': courseSkel },
      { 'b.anim': 'no clip' },
    ];
    expect(await openWith(true, ...own)).toEqual({ asked: ['b'], names: ['a', 'b'] });
  });

  it('is not asked on the first scene, which nobody touched: all of it is replaced', async () => {
    const { run, store } = await open({ kind: 'bundled', id: 'a' });
    const ask = (): never => expect.unreachable('nothing is to be asked');
    await run([memoryFile('b.skel', bytesOf(courseSkel))], undefined, { add: false, ask });
    expect(store.scene.value.actors.map(({ character }) => character.name)).toEqual(['b']);
    store.undo();
    expect(store.scene.value.actors.map(({ character }) => character.name)).toEqual(['a', 'a']);
  });

  it('adds beside the others, but gives poses and clips to the selected character', async () => {
    const { run, store } = await open();
    const add = (files: FileContents) =>
      run(
        Object.entries(files).map(([name, text]) => memoryFile(name, bytesOf(text))),
        undefined,
        { add: true },
      );
    await add(leg);
    const [clip, ...rest] = Object.keys(leg).filter((name) => name.endsWith('.anim'));
    expect(rest).toEqual([]);
    expect(await add({ [clip!]: leg[clip!]! })).toMatchObject({
      kept: expect.stringContaining('kept') as string,
      added: false,
    });
    expect(store.scene.value.actors.map(({ character }) => character.name)).toEqual(['a', 'leg']);
    expect(await add(another)).toMatchObject({ added: true });
    expect(store.scene.value.actors).toHaveLength(3);
  });
});
