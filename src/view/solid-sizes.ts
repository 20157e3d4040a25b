/** The handout's sizes (3.2.2) for a character about one unit tall, in scene units. */
export const jointRadius = 0.025;
export const boneRadius = 0.02;
/**
 * The distance from its axis within which a bone is picked: 0.25 for the 20 units of a CS354
 * character.
 */
export const boneReach = 0.25 / 20;
