import { printable } from '../core/diagnostics.ts';

/** After so many milliseconds without a letter, the next one begins another word. */
const pause = 800;

/**
 * Finds rows by what is typed: letters in quick succession are one word, and one letter again and
 * again goes from row to row. A row is found by the start of any word of its name, after the present
 * row first, and then from the top.
 */
export class TypeAhead {
  private typed = '';
  private last = -Infinity;

  /**
   * @param names of all rows
   * @param at the present row
   * @param time of the key press, in milliseconds
   * @returns the row, or -1 if none fits
   */
  find(names: readonly string[], at: number, letter: string, time: number): number {
    const isNew = time - this.last > pause;
    this.typed = isNew ? letter : this.typed + letter;
    this.last = time;
    const isOneLetter = Array.from(this.typed).every((each) => each === letter);
    const wanted = (isOneLetter ? letter : this.typed).toLowerCase();
    // A word that goes on may still fit the present row; a letter alone looks for another one.
    const first = isOneLetter ? at + 1 : at;
    const fits = (name: string): boolean => {
      const plain = printable(name, 200).toLowerCase();
      return (
        plain.startsWith(wanted) || plain.split(/[\s_.:-]+/).some((word) => word.startsWith(wanted))
      );
    };
    for (let i = 0; i < names.length; i++) {
      const row = (first + i) % names.length;
      if (fits(names[row]!)) return row;
    }
    return -1;
  }

  /** Whether a word is being typed, of which a blank is a part. */
  isTyping(time: number): boolean {
    return this.typed !== '' && time - this.last <= pause;
  }
}
