import type { Skeleton } from '../../core/skeleton.ts';

export type Side = 'left' | 'right';

/** What a joint's name tells about its side. */
export interface SidedName {
  readonly side: Side;
  /** The name with a mark in place of the side, equal for the two joints of a pair. */
  readonly stem: string;
}

const words: ReadonlyMap<string, Side> = new Map<string, Side>([
  ['左', 'left'],
  ['右', 'right'],
  ['left', 'left'],
  ['right', 'right'],
]);
const letters: ReadonlyMap<string, Side> = new Map<string, Side>([
  ['l', 'left'],
  ['r', 'right'],
]);

/**
 * Returns the side in a joint's name, or null if it names none: as a word (`Left arm`,
 * `mixamorig:LeftArm`, `leftarm`, `左腕`) or as a letter of its own (`arm.L`, `l_arm`,
 * `leg_l1_coxa`, `lShldr`, `LArm`). Full-width letters count as letters.
 */
export function sideOfName(name: string): SidedName | null {
  const tokens = name.normalize('NFKC').match(/[左右]|[A-Z]+(?![a-z])|[A-Z]?[a-z]+|./gsu) ?? [];
  const lower = tokens.map((token) => token.toLowerCase());
  const sided = (token: number, side: Side, rest = ''): SidedName => ({
    side,
    stem: lower.toSpliced(token, 1, `*${rest}`).join(''),
  });
  for (const [index, token] of lower.entries()) {
    const side = words.get(token);
    if (side) return sided(index, side);
  }
  for (const [index, token] of lower.entries()) {
    const [, word = '', rest = ''] = /^(left|right)(.+)$/.exec(token) ?? [];
    const side = words.get(word);
    if (side) return sided(index, side, rest);
  }
  for (const [index, token] of lower.entries()) {
    const side = letters.get(token);
    if (side) return sided(index, side);
  }
  return null;
}

/** The side in a joint's name or, if that names none, in its English name. */
export function sideOfJoint(
  { names, englishNames }: Pick<Skeleton, 'names' | 'englishNames'>,
  joint: number,
): SidedName | null {
  return sideOfName(names[joint]!) ?? sideOfName(englishNames?.[joint] ?? '');
}
