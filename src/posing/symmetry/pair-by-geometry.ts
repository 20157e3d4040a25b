/** Where the joints of a character are, as far as its symmetry is concerned. */
export interface JointPlaces {
  /** (jointCount) -1 is a root. */
  readonly parents: Int16Array;
  /** How far the mirror image of one joint is from another one, which may be itself. */
  readonly distance: (a: number, b: number) => number;
  /** (jointCount) whether its name tells a side, so that it does not belong on the plane. */
  readonly isSided: readonly boolean[];
  /** Up to this distance, places count as equal. */
  readonly tolerance: number;
}

const noPartner = -1;

/**
 * Completes the partners of joints: those of unpaired ones are found among the children of paired
 * parents, by their places and those of all joints below them. A joint whose branch is its own
 * mirror image lies on the plane; then come pairs of branches, the nearest ones first; then the
 * other joints that are themselves on the plane, as a head with uneven hair.
 *
 * @param given (jointCount) the partners that are known, and -1 for the other joints
 */
export function pairByGeometry(places: JointPlaces, given: Int16Array): Int16Array {
  const { parents, tolerance, distance, isSided } = places;
  const partners = given.slice();
  /** The children of each joint; those of none, the roots, are the last. */
  const children = Array.from({ length: parents.length + 1 }, (): number[] => []);
  parents.forEach((parent, joint) => children.at(parent)!.push(joint));
  const apart = branchDistances(places, children);
  const pair = (a: number, b: number): void => {
    if (partners[a] !== noPartner || partners[b] !== noPartner) return;
    partners[a] = b;
    partners[b] = a;
  };

  // Parents come before their children, so theirs are known.
  for (let parent = -1; parent < parents.length; parent++) {
    const other = parent === -1 ? -1 : partners[parent]!;
    if ((parent >= 0 && other === noPartner) || other < parent) continue;
    const free = (joint: number): boolean => partners[joint] === noPartner;
    const own = children.at(parent)!.filter(free);
    const opposite = children.at(other)!.filter(free);
    if (parent === other) {
      for (const joint of own) if (apart(joint, joint) <= tolerance) pair(joint, joint);
    }
    const choices = own
      .flatMap((a) => opposite.map((b) => ({ a, b, cost: a === b ? Infinity : apart(a, b) })))
      .filter(({ cost }) => cost <= tolerance)
      .sort((first, second) => first.cost - second.cost);
    for (const { a, b } of choices) pair(a, b);
    if (parent !== other) continue;
    for (const joint of own) {
      if (!isSided[joint] && distance(joint, joint) <= tolerance) pair(joint, joint);
    }
  }
  return partners;
}

/**
 * Returns a function that tells how far the mirror image of one branch is from another: the largest
 * distance of a joint, or infinity if a joint is too far away or they have other numbers of joints.
 */
function branchDistances(
  { tolerance, distance }: JointPlaces,
  children: readonly (readonly number[])[],
): (a: number, b: number) => number {
  const known = new Map<string, number>();
  return function apart(a, b) {
    const own = distance(a, b);
    const [below, opposite] = [children[a]!, children[b]!];
    if (!(own <= tolerance) || below.length !== opposite.length) return Infinity;
    const key = `${a} ${b}`;
    let found = known.get(key);
    if (found === undefined) {
      found = below.reduce((largest, child) => {
        const nearest = Math.min(...opposite.map((each) => apart(child, each)));
        return Math.max(largest, nearest);
      }, own);
      known.set(key, found);
    }
    return found;
  };
}
