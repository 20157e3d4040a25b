/** The handout's sizes (3.2.2) for a character about one unit tall, scene units. */
export const jointRadius = 0.025;
export const boneRadius = 0.02;
/** How near to its axis a bone is picked: 0.25 for the 20 units of a character of CS354. */
export const boneReach = 0.25 / 20;
