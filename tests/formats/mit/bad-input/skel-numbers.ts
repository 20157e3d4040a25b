import { type BadInput, meshOnly, withSkel } from './bad-input.ts';

/** A `.skel` with this second line. */
function line(text: string): string {
  return `0 0 0 -1\n${text}\n0 1 0 1\n`;
}

function refused(title: string, text: string, message: string): BadInput {
  return { title, files: withSkel(text), messages: [`error: a.skel${message}`], left: meshOnly };
}

/** A number for y, at the sixth byte of the second line. */
function badNumber(title: string, y: string, hint = ''): BadInput {
  const message = `:2:3: expected a number for y${hint}, found "${y}" [skel/number]`;
  return refused(title, line(`0 ${y} 0 0`), message);
}

function badParent(title: string, parent: string): BadInput {
  const message = `:2:7: expected -1 or the index of a joint, found "${parent}" [skel/integer]`;
  return refused(title, line(`0 1 0 ${parent}`), message);
}

const fields = ':2: expected "tx ty tz parent", found';

/** A1 to A13 and A20: lines and numbers of a `.skel`. */
export const skelNumbers: readonly BadInput[] = [
  refused('A1 empty file', '', ': expected .skel text, found "an empty file" [file/empty]'),
  refused(
    'A2 only blanks and comments',
    ' \n# nothing\n\t\n',
    ': expected at least one joint, found "none" [skel/empty]',
  ),
  refused('A3 three fields', line('0 1 0'), `${fields} "3 fields" [skel/field-count]`),
  refused('A4 five fields', line('0 1 0 0 0'), `${fields} "5 fields" [skel/field-count]`),
  badNumber('A5 nan', 'nan'),
  badNumber('A6 inf', 'inf'),
  badNumber('A6 Infinity', '-Infinity'),
  refused(
    'A7 beyond float32',
    line('0 1e39 0 0'),
    ':2:3: expected y within ±1e18, found "1e39" [skel/range]',
  ),
  refused(
    'A7 beyond what lengths can be computed with',
    line('0 0 -1.1e18 0'),
    ':2:5: expected z within ±1e18, found "-1.1e18" [skel/range]',
  ),
  badNumber('A8 hexadecimal', '0x10'),
  badNumber('A9 decimal comma', '0,5', ' with a decimal point'),
  badNumber('A10 two points', '1.2.3'),
  badNumber('A10 two signs', '--1'),
  badNumber('A10 unfinished exponent', '1e'),
  badNumber('A10 sign alone', '+'),
  badParent('A11 fraction as parent', '0.5'),
  badParent('A12 negative parent', '-2'),
  refused(
    'A13 parent past the end',
    line('0 1 0 3'),
    ':2:7: expected a parent from -1 to 2, found "3" [character/parent]',
  ),
  badParent('A20 parent past any integer', '99999999999999999999'),
  badParent('A20 parent of too many digits', '1'.repeat(30)),
  refused(
    'A20 parent that wraps to 0 in 32 bits',
    line('0 1 0 4294967296'),
    ':2:7: expected a parent from -1 to 2, found "4294967296" [character/parent]',
  ),
];
