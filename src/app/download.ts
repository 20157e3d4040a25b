import { plainName } from '../formats/belonging/plain-path.ts';

/** Hands bytes to the user as a file. */
export function download(name: string, content: BlobPart, type: string): void {
  const url = URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement('a');
  link.href = url;
  link.download = plainName(name); // it may come from a file
  link.click();
  // The browser takes the URL at the click; it is kept a moment for those that are late.
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
