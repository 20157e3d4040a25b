import type { Skeleton } from '../../core/skeleton.ts';
import { type Side, sidedName } from '../symmetry/name-sides.ts';
import { type JointRole, limbRoles } from './roles.ts';

/**
 * What one name alone says: a role, nothing (null), or a word that means different joints in
 * different conventions and is understood by the joints beside it.
 */
type Meaning = JointRole | 'shoulder?' | 'leg?' | 'hip?' | 'arm?' | null;

/**
 * Patterns of names without side, spaces and digits; the first match counts. Japanese names are those
 * of PMD models. Mere ends, helpers, goals of inverse kinematics and copies (D) have no role.
 */
const meanings: readonly (readonly [RegExp, Meaning])[] = [
  [/つま先$/u, 'toe'],
  [/ik(先|親)?$|(先|[^a-z][dpc]|補|補助|キャンセル|end|tip|nub|pole|target|helper)$/u, null],
  [/twist|roll|捩|捻/u, 'twist'],
  [/metacarpal|palm|hair|eye|jaw|mouth|tail|wing|antenna|mandible|abdomen/, null],
  [/thumb|親指/u, 'thumb'],
  [
    /index|middle|(^f?|hand)ring|pinky|pinkie|little|finger|knuckle|[小薬中示]指|人差?指/u,
    'finger',
  ],
  [/toe|^ball$/, 'toe'],
  [/ankle|foot|feet|足首/u, 'ankle'],
  [/knee|shin|calf|(lower|lo)leg|ひざ|膝/u, 'knee'],
  [/thigh|(upper|up)leg|^足$|太もも|もも/u, 'hip'],
  [/elbow|(fore|lower|lo)arm|ひじ|肘/u, 'elbow'],
  [/wrist|hand$|手首/u, 'wrist'],
  [/clavicle|collar|鎖骨|^肩$/u, 'clavicle'],
  [/(upper|up)arm|^腕$/u, 'shoulder'],
  [/shoulder$|shldr$/, 'shoulder?'],
  [/arm$/, 'arm?'],
  [/leg$/, 'leg?'],
  [/pelvis|hips|下半身|lowerbody|^腰$/u, 'pelvis'],
  [/hip$/, 'hip?'],
  [/neck|首/u, 'neck'],
  [/head$|^頭$/u, 'head'],
  [/spine|chest|back$|waist|torso|thorax|upperbody|上半身|^胸$/u, 'spine'],
  [/root|center|centre|センター|全ての親|グルーブ/u, 'root'],
];

/** Words of bodies whose arms and legs are not a human's. */
const otherBody =
  /(hind|front|rear)(upper|lower)?(leg|limb|foot)|leg(hind|front|rear)|coxa|tarsus|hoof|paw|^wing/;

/** What the names of a skeleton say. */
export interface NamedRoles {
  readonly roles: readonly (JointRole | null)[];
  readonly sides: readonly (Side | null)[];
  /** Whether the names belong to a body that has other limbs than a human's. */
  readonly isOtherBody: boolean;
}

/** Finds the roles of joints by their names, and by their English ones where they have such. */
export function namedRoles(skeleton: Skeleton): NamedRoles {
  const { names, englishNames, jointCount } = skeleton;
  const english = (joint: number): string => englishNames?.[joint] ?? '';
  const sides = names.map((name, joint) => sidedName(name).side ?? sidedName(english(joint)).side);
  const meant = names.map((name, joint) => {
    const own = meaningOf(name);
    return own === undefined ? (meaningOf(english(joint)) ?? null) : own;
  });
  const roles = new Array<JointRole | null>(jointCount).fill(null);
  // From the tips to the roots, since what an unclear word means is told by the joints below it.
  for (let joint = jointCount - 1; joint >= 0; joint--) {
    const below = (role: JointRole): boolean => hasBelow(skeleton, roles, joint, role);
    const parent = skeleton.parents[joint]!;
    roles[joint] = clearRole(meant[joint]!, below, parent < 0 ? null : meant[parent]!);
  }
  const isOtherBody =
    names.some((name) => otherBody.test(lettersOf(name))) || hasMoreLimbs(roles, sides);
  // An arm or a leg has a side; of another body only the trunk is clear.
  const kept = roles.map((role, joint) => {
    const isLimb = role !== null && limbRoles.has(role);
    if (isOtherBody) return isLimb || isOfHand(role) || sides[joint] !== null ? null : role;
    return isLimb && sides[joint] === null ? null : role;
  });
  return { roles: kept, sides, isOtherBody };
}

/** Undefined where no pattern knows the name. */
function meaningOf(name: string): Meaning | undefined {
  const letters = lettersOf(name);
  return meanings.find(([pattern]) => pattern.test(letters))?.[1];
}

/** The letters of a name without those of its side, in lower case. */
function lettersOf(name: string): string {
  return sidedName(name).stem.replace(/[^\p{L}\p{M}ー]/gu, '');
}

function clearRole(
  meaning: Meaning,
  below: (role: JointRole) => boolean,
  above: Meaning,
): JointRole | null {
  // The collarbone where an upper arm follows (Mixamo), else the shoulder.
  if (meaning === 'shoulder?') return below('shoulder') ? 'clavicle' : 'shoulder';
  if (meaning === 'arm?') return 'shoulder';
  // The shank below a thigh (Mixamo), else the thigh.
  const isBelowThigh = above === 'hip' || above === 'hip?';
  if (meaning === 'leg?') return isBelowThigh && !below('knee') ? 'knee' : 'hip';
  // The hip joint where a knee follows, else the side of the pelvis.
  if (meaning === 'hip?') return below('knee') && !below('hip') ? 'hip' : 'pelvis';
  return meaning;
}

/** Whether a descendant has the role. */
function hasBelow(
  { depths, jointCount }: Skeleton,
  roles: readonly (JointRole | null)[],
  joint: number,
  role: JointRole,
): boolean {
  for (let at = joint + 1; at < jointCount && depths[at]! > depths[joint]!; at++) {
    if (roles[at] === role) return true;
  }
  return false;
}

/** More than one elbow or knee on a side. */
function hasMoreLimbs(
  roles: readonly (JointRole | null)[],
  sides: readonly (Side | null)[],
): boolean {
  return (['elbow', 'knee'] as const).some((role) =>
    (['left', 'right'] as const).some(
      (side) => roles.filter((each, i) => each === role && sides[i] === side).length > 1,
    ),
  );
}

function isOfHand(role: JointRole | null): boolean {
  return role === 'finger' || role === 'thumb';
}
