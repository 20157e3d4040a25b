import { randomBetween, randomSource } from '../../tests/support/random.ts';
import type { NamedFile } from './app.ts';

/**
 * Makes the files of a character with this many joints, and influences per vertex. They are the
 * same in every run.
 */
export function madeCharacter(jointCount: number, influenceCount: number): NamedFile[] {
  const random = randomSource(jointCount * 100 + influenceCount);
  const coordinate = (): string => randomBetween(random, -1, 1).toFixed(4);
  const vertexCount = 60;
  const numbered = <T>(count: number, make: (index: number) => T): T[] =>
    Array.from({ length: count }, (_, index) => make(index));
  const point = (): string => `${coordinate()} ${coordinate()} ${coordinate()}`;
  // Chains are short, because in long ones the angles of a pose accumulate until the vertices are
  // noise.
  const joint = (index: number): string =>
    `${point()} ${index === 0 ? -1 : index % 8 && index - 1}`;
  const row = (): string => {
    const weights = new Array<string>(jointCount - 1).fill('0');
    for (let i = 0; i < influenceCount; i++) {
      const column = Math.floor(((i + random()) / influenceCount) * weights.length);
      weights[column] = (1 / influenceCount).toFixed(4);
    }
    return weights.join(' ');
  };
  const files = {
    skel: numbered(jointCount, joint),
    obj: [
      ...numbered(vertexCount, () => `v ${point()}`),
      ...numbered(vertexCount - 2, (index) => `f ${index + 1} ${index + 2} ${index + 3}`),
    ],
    attach: numbered(vertexCount, row),
  };
  return Object.entries(files).map(([kind, lines]) => ({
    name: `made.${kind}`,
    content: `${lines.join('\n')}\n`,
  }));
}
