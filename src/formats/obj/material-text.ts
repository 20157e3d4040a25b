/**
 * A material's name as an OBJ can hold it: on one line, no blanks around it, and no backslash at its
 * end, which would join the next line to it.
 */
export function materialText(name: string): string {
  return name
    .replace(/[\0\r\n]+/g, ' ')
    .trim()
    .replace(/[\\\s]+$/, '');
}
