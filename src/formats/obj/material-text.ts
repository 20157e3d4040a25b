/**
 * A material's name in a form that an OBJ can hold: on one line, without blanks around it, and
 * without a backslash at its end, which would continue the line.
 */
export function materialText(name: string): string {
  return name
    .replace(/[\0\r\n]+/g, ' ')
    .trim()
    .replace(/[\\\s]+$/, '');
}
