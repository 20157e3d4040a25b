/** What limits a value, where it misses its aim; by the ids of bench/goals.ts. */
export const limits: Readonly<Record<string, string>> = {};
