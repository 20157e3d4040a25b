/** The handout's sizes (3.2.2) for a character about one unit tall, scene units. */
export const jointRadius = 0.025;
export const boneRadius = 0.02;
