import type { GUI } from 'lil-gui';

/** Adds a line of text below the rows of a folder, and returns it. */
export function addNote(folder: GUI, text: string): HTMLElement {
  const note = document.createElement('p');
  note.className = 'note';
  note.textContent = text;
  folder.$children.append(note);
  return note;
}
