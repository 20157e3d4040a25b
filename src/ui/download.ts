import { plainName } from '../formats/belonging/plain-path.ts';

/** Offers bytes to the user as a download. */
export function download(name: string, content: BlobPart, type: string): void {
  const url = URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement('a');
  link.href = url;
  link.download = plainName(name); // the name may come from a file
  link.click();
  // Most browsers fetch the URL at the click; it is kept for a moment for those that are late.
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
