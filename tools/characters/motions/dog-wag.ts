import { cycle, type Design, type Turn } from './curves.ts';

/** Two swings to both sides are one turn of the clip; in seconds. */
const [length, stroke] = [1.2, 0.3];
const tailJoints = 21;

/** The dog wags its tail: a wave that runs to the tip. */
export const dogWag: Design = {
  length,
  isCycle: true,
  joints: {
    ...Object.fromEntries(
      Array.from({ length: tailJoints }, (_, at): [string, Turn] => {
        const along = at / (tailJoints - 1);
        // The root of the tail swings widely, and its tip follows late.
        const reach = 0.11 * (1 - along) + 0.045;
        return [`Tail ${at + 1}`, [at < 6 ? -0.07 : 0.01, swing(reach, along * 0.3), 0]];
      }),
    ),
  },
};

/** A swing from side to side that is late by parts of a swing. */
function swing(reach: number, late: number): Turn[0] {
  const count = (length / stroke / 2) * 8;
  return cycle(
    length,
    Array.from({ length: count }, (_, at) => reach * Math.sin(2 * Math.PI * (at / 8 - late))),
  );
}
