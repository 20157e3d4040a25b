import { Failure } from '../core/failure.ts';
import type { FileEntry } from '../formats/format.ts';
import { isJunk } from '../formats/junk.ts';
import type { RecentFiles } from '../ui/editor.ts';
import { fileEntry, unreadableEntry } from '../ui/file-entry.ts';
import { inStore } from './storage.ts';

/** As many as the gallery lists. */
const mostRecent = 8;

interface StoredFiles extends RecentFiles {
  /** When they were opened, in milliseconds since 1970. */
  readonly time: number;
}

/** What was opened lately on this machine, the last first. */
export async function listRecent(): Promise<readonly RecentFiles[]> {
  const stored = await inStore<StoredFiles[]>('recent', 'readonly', (store) => store.getAll());
  return (stored ?? []).sort((a, b) => b.time - a.time);
}

/** Remembers what was opened, in place of earlier files of the same name. */
export async function rememberFiles(
  name: string,
  handles: readonly FileSystemHandle[],
): Promise<void> {
  const stored: StoredFiles = { name, handles, time: Date.now() };
  await inStore('recent', 'readwrite', (store) => store.put(stored));
  for (const { name: oldest } of (await listRecent()).slice(mostRecent)) {
    await inStore('recent', 'readwrite', (store) => store.delete(oldest));
  }
}

export async function forgetRecent(): Promise<void> {
  await inStore('recent', 'readwrite', (store) => store.clear());
}

/**
 * Lists the files behind handles, including those in folders. The browser may ask the user first.
 *
 * @throws Failure if the user does not allow it
 */
export async function filesOf(handles: readonly FileSystemHandle[]): Promise<FileEntry[]> {
  for (const handle of handles) {
    const answer = await handle.requestPermission?.({ mode: 'read' });
    if (answer === 'denied' || answer === 'prompt') {
      throw new Failure(`The browser may not read ${handle.name}; choose the files again`);
    }
  }
  const lists = await Promise.all(handles.map((handle) => entriesOf(handle, handle.name)));
  return lists.flat();
}

async function entriesOf(handle: FileSystemHandle, path: string): Promise<FileEntry[]> {
  if (isJunk(handle.name)) return [];
  try {
    if (isFile(handle)) return [await fileEntry(await handle.getFile(), path)];
    const found: FileEntry[] = [];
    for await (const inside of (handle as FileSystemDirectoryHandle).values()) {
      found.push(...(await entriesOf(inside, `${path}/${inside.name}`)));
    }
    return found;
  } catch (error) {
    return [unreadableEntry(path, error)];
  }
}

function isFile(handle: FileSystemHandle): handle is FileSystemFileHandle {
  return handle.kind === 'file';
}
