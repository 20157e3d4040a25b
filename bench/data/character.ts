import { buildCharacter } from '../../src/core/build-character.ts';
import type { JointParts } from '../../src/core/character-parts.ts';
import type { Character } from '../../src/core/character.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import type { Cylinder } from './cylinder.ts';

/** Builds the body with the product's code. Value 3 j + a of its pose turns joint j about axis a. */
export function characterOf(body: Cylinder): Character {
  const { value } = buildCharacter({
    name: 'body',
    missing: [],
    skeleton: {
      file: 'body.skel',
      joints: Array.from({ length: body.jointCount }, (_, joint) =>
        jointOf(joint, body.jointSpacing),
      ),
    },
    mesh: { file: 'body.obj', positions: body.positions, cornerPoints: body.indices },
    skin: {
      file: 'body.attach',
      start: body.start,
      joints: body.joints,
      weights: body.weights,
    },
  });
  if (!value) throw new Error('the body can be built');
  return value;
}

function jointOf(joint: number, spacing: number): JointParts {
  return {
    name: `joint ${joint}`,
    parent: joint - 1,
    restOffset: [0, joint === 0 ? 0 : spacing, 0],
    dofs: ([0, 1, 2] as const).map((axis) => ({
      kind: DofKind.hinge,
      axis: [axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0],
    })),
  };
}
