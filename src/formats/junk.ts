/** Whether a file was added by an operating system: resource forks, folder settings, previews. */
export function isJunk(path: string): boolean {
  return path
    .split(/[/\\]/)
    .some((part) => part.startsWith('._') || junkNames.has(part.toLowerCase()));
}

const junkNames = new Set(['__macosx', '.ds_store', 'thumbs.db', 'desktop.ini', '.git']);
