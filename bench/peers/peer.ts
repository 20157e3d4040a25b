/**
 * Loads a file of this folder. The peers are installed for the bench alone, so the compiler may not
 * know them; whoever loads a file states what it needs of it.
 */
export async function loadPeer<T>(name: string): Promise<T> {
  return (await import(`./${name}.mjs`)) as T;
}
