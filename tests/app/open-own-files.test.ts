import { describe, expect, it } from 'vitest';
import { FileOpener } from '../../src/app/open-files.ts';
import { openOwnFiles } from '../../src/app/open-own-files.ts';
import { pictureKeyword, writePictureNote } from '../../src/app/picture-note.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { memoryFile } from '../../src/formats/file-entry.ts';
import type { FileEntry } from '../../src/formats/format.ts';
import { insertPngText } from '../../src/formats/png/text-chunk.ts';
import { courseSkel } from '../support/course-skeleton.ts';
import { bytesOf, readOne } from '../support/files.ts';

async function open() {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  const opener = new FileOpener(store, session, new Evaluations(store, session), () => ({}));
  store.dispatch(openCharacter(null, await readOne({ 'a.skel': courseSkel }), 'linear-blend'));
  const [scene, problems] = [store.scene.value, session.problems.value];
  const current = new AbortController();
  const aborted = (): void => current.abort();
  const run = (files: readonly FileEntry[], openBundled = () => Promise.resolve()) =>
    openOwnFiles(opener, files, {
      signal: current.signal,
      onProgress: () => undefined,
      openBundled,
      add: false,
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
  const note = writePictureNote({ bundled, name: 'Any', pose: { joints: { '#0': [1, 0, 0] } } });
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
