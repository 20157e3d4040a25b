/** Something that is found by the letters of its label. */
export interface Findable {
  readonly id: string;
  readonly label: string;
  /** Whether it is a command of the table; those come before what is made from data. */
  readonly isCommand: boolean;
}

/** How well a label fits what was typed; the first that holds counts. */
const fits: readonly ((label: string, query: string) => boolean)[] = [
  (label, query) => label.startsWith(query),
  (label, query) => wordStarts(label).some((start) => label.startsWith(query, start)),
  (label, query) => label[0] === query[0] && startsWords(label, query.replaceAll(' ', '')),
  (label, query) => startsWords(label, query.replaceAll(' ', '')),
  (label, query) => label.includes(query),
  (label, query) => hasInOrder(label, query.replaceAll(' ', '')),
];

/**
 * Returns the entries that fit what was typed, the best first. Labels that start with it come first,
 * then those with a word that does, then those whose words start with its parts ("le el" or "leel":
 * left elbow), those of the first word before others, then those that contain it, then those with
 * its letters in order. Among equals, commands come first, then what was used lately, then short
 * labels.
 *
 * @param recent ids, the last used first
 */
export function rankEntries<Entry extends Findable>(
  entries: readonly Entry[],
  typed: string,
  recent: readonly string[],
): Entry[] {
  const query = typed.trim().toLowerCase();
  return entries
    .map((entry) => ({ entry, order: orderOf(entry, query, recent) }))
    .filter(({ order: [fit] }) => fit !== -1)
    .sort((a, b) => compare(a.order, b.order))
    .map(({ entry }) => entry);
}

/** Whether a label fits what was typed at all. */
export function fitsQuery(label: string, typed: string): boolean {
  const query = typed.trim().toLowerCase();
  return fits.slice(0, -1).some((fit) => fit(label.toLowerCase(), query));
}

/** What entries are ordered by; the first number is -1 if the entry does not fit. */
function orderOf(
  { id, label, isCommand }: Findable,
  query: string,
  recent: readonly string[],
): readonly [number, ...number[]] {
  const fit = fits.findIndex((each) => each(label.toLowerCase(), query));
  const used = recent.indexOf(id);
  return [fit, isCommand ? 0 : 1, used === -1 ? recent.length : used, label.length];
}

function compare(a: readonly number[], b: readonly number[]): number {
  const first = a.findIndex((value, index) => value !== b[index]);
  return first === -1 ? 0 : a[first]! - b[first]!;
}

/** Whether the letters are starts of words of the label, in order; words may be left out. */
function startsWords(label: string, letters: string): boolean {
  const starts = wordStarts(label);
  const follow = (word: number, from: number): boolean => {
    if (from === letters.length) return true;
    for (; word < starts.length; word++) {
      for (let end = from; label[starts[word]! + end - from] === letters[end];) {
        if (follow(word + 1, ++end)) return true;
        if (end === letters.length) break;
      }
    }
    return false;
  };
  return follow(0, 0);
}

/** Where the words of a label start. */
function wordStarts(label: string): number[] {
  return Array.from(label.matchAll(/[^\s_,;:()-]+/g), ({ index }) => index);
}

function hasInOrder(label: string, letters: string): boolean {
  let from = 0;
  for (const letter of letters) {
    from = label.indexOf(letter, from) + 1;
    if (from === 0) return false;
  }
  return true;
}
