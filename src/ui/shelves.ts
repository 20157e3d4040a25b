import { formatExtensions } from '../formats/extensions.ts';
import type { FormatId } from '../formats/registry.ts';
import type { BundledCharacter } from './editor.ts';
import { fitsQuery } from './rank-entries.ts';

/** The bundled characters whose files are those of a course. */
export interface Shelf {
  readonly label: string;
  /** The files of the course: ".skel, .obj, .attach". */
  readonly files: string;
  readonly cards: readonly BundledCharacter[];
}

/** Every course, in the order of the gallery. To add one, add a row. */
const courses: readonly { readonly id: FormatId; readonly label: string }[] = [
  { id: 'mit', label: 'MIT 6.837' },
  { id: 'cse169', label: 'UCSD CSE169' },
  { id: 'mmd', label: 'UT CS354' },
];

/** The shelves of the gallery that have cards, filtered by the names of characters and courses. */
export function shelvesOf(bundled: readonly BundledCharacter[], typed: string): readonly Shelf[] {
  return courses
    .map(({ id, label }) => ({
      label,
      files: formatExtensions[id].join(', '),
      cards: bundled.filter(
        (each) => each.course === id && fitsQuery(`${each.label} ${label}`, typed),
      ),
    }))
    .filter(({ cards }) => cards.length > 0);
}
