/**
 * Loads a file of bench/peers. The peers are installed for the bench alone, so the compiler may not
 * know them; whoever loads a file states what it needs of it.
 */
export async function loadPeer<T>(name: string): Promise<T> {
  return (await import(/* @vite-ignore */ `../peers/${name}.mjs`)) as T;
}
