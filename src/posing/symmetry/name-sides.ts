/** The sides of a character's own body, as the words of its joints' names say them. */
export type Side = 'left' | 'right';

/** A name, parted into its side and the rest, which is equal in both names of a pair. */
export interface SidedName {
  /** Null where the name says no side, or both. */
  readonly side: Side | null;
  /** The words of the name in lower case without that of the side, one space between them. */
  readonly stem: string;
}

const sideOfWord: Readonly<Record<string, Side>> = {
  left: 'left',
  lft: 'left',
  l: 'left',
  左: 'left',
  right: 'right',
  rgt: 'right',
  r: 'right',
  右: 'right',
};

/**
 * Parts a joint's name into its side and the rest. Known are left and right as words (`Left arm`,
 * `wing_1_right`, `mixamorig:LeftArm`, `leftarm`), their letters as words of their own (`L_arm`,
 * `arm.L`, `lHand`, `leg_l1_femur`) and 左 and 右, which Japanese names begin with.
 */
export function sidedName(name: string): SidedName {
  const words = nameWords(name);
  const sides = words.map((word) => (words.length > 1 ? sideOfWord[word] : undefined));
  const found = new Set(sides.filter((side) => side !== undefined));
  if (found.size !== 1) return { side: null, stem: words.join(' ') };
  const [side] = found;
  return { side: side!, stem: words.filter((_, i) => sides[i] === undefined).join(' ') };
}

/**
 * The words of a name in lower case. Half-width and full-width characters become the usual ones,
 * capitals begin words, and numbers and the signs of a side are words of their own.
 */
function nameWords(name: string): string[] {
  const spaced = name
    .normalize('NFKC')
    .replace(/([左右])/g, ' $1 ')
    .replace(/([a-z\d])([A-Z])/g, '$1 $2')
    .replace(/([A-Z])([A-Z][a-z])/g, '$1 $2')
    .toLowerCase()
    .replace(/(\p{L})(\d)|(\d)(\p{L})/gu, '$1$3 $2$4')
    .replace(/(^|[^a-z])(left|right)(?=[a-z]{2})/g, '$1$2 ');
  return spaced.split(/[^\p{L}\p{M}\d]+/u).filter((word) => word !== '');
}
