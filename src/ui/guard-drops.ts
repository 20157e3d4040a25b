/** Keeps the browser from leaving the page for a file that is dropped before the page takes files. */
export function guardDrops(): void {
  for (const type of ['dragover', 'drop']) {
    window.addEventListener(type, (event) => event.preventDefault());
  }
}
