/** Returns the same numbers in every run: mulberry32 (Ettinger 2017), uniform over 0 … 1. */
export function randomSource(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

export function randomBetween(random: () => number, low: number, high: number): number {
  return low + (high - low) * random();
}

export function randomUnitVector(random: () => number): number[] {
  for (;;) {
    const vector = [0, 1, 2].map(() => randomBetween(random, -1, 1));
    const length = Math.hypot(...vector);
    if (length > 0.1 && length < 1) return vector.map((value) => value / length);
  }
}

/** A quaternion x, y, z, w that rotates by at most `angle`. */
export function randomRotation(random: () => number, angle: number): number[] {
  const half = randomBetween(random, -angle, angle) / 2;
  return [...randomUnitVector(random).map((value) => value * Math.sin(half)), Math.cos(half)];
}

/** 0 … count - 1 in random order. */
export function shuffled(random: () => number, count: number): number[] {
  const order = Array.from({ length: count }, (_, index) => index);
  for (let i = count - 1; i > 0; i--) {
    const j = Math.floor(random() * (i + 1));
    [order[i], order[j]] = [order[j]!, order[i]!];
  }
  return order;
}
