import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { setPose } from '../../src/document/edits.ts';
import { setFitted, setTransform, turnedBy } from '../../src/document/place-edits.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { type Actor, emptyScene, unmoved } from '../../src/document/scene.ts';
import { displayTransform } from '../../src/evaluation/display-transform.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { lowestPoint } from '../../src/evaluation/lowest-point.ts';
import { placeBeside } from '../../src/evaluation/place-beside.ts';
import { sceneBounds } from '../../src/evaluation/scene-bounds.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';
import { multiply, rotationOf, transform, translation } from '../reference/matrix.ts';

const character = characterOfRig(rotatedTree());
const first = openCharacter(null, character, 'linear-blend').apply(emptyScene);
const edited = (...edits: readonly { apply(scene: typeof first): typeof first }[]): Actor =>
  edits.reduce((scene, edit) => edit.apply(scene), first).actors[0]!;
const { id } = first.actors[0]!;
const posed = setPose(
  id,
  character.skeleton.qRest.map((value, i) => value + 0.3 * Math.sin(i)),
);
const number = fc.double({ min: -3, max: 3, noNaN: true });

describe('a character that is set on the floor', () => {
  it('touches it with its lowest vertex, however it is posed, leaned and scaled', () => {
    fc.assert(
      fc.property(number, number, number, fc.boolean(), (lean, side, height, fitted) => {
        const leaned = turnedBy(turnedBy(unmoved, [1, 0, 0], lean), [0, 0, 1], side);
        const placed = { ...leaned, position: [1, height, -2], scale: 1.7 } as const;
        const edits = [posed, setFitted(first.actors[0]!, fitted)];
        const actor = edited(...edits, setTransform(id, placed, 'Place'));
        const lowest = lowestPoint(new Evaluator(actor));
        const down = { ...placed, position: [1, height - lowest, -2] } as const;
        const set = new Evaluator(edited(...edits, setTransform(id, down, 'Set')));
        const { positions } = set.vertices();
        const { sceneFromCharacter, scale } = set.display;
        // Independent of the code: the rotation, then the height of the origin of the character.
        const heights = Array.from({ length: positions.length / 3 }, (_, i) => {
          const at = [...positions.subarray(i * 3, i * 3 + 3)].map((value) => value * scale);
          return transform(rotationOf(down.rotation), at)[1]! + sceneFromCharacter[13]!;
        });
        expect(Math.min(...heights)).toBeCloseTo(0, 6);
      }),
      { numRuns: 60 },
    );
  });
});

describe('a character in its own units', () => {
  it('stands where its file has it; its transform acts about the file’s origin', () => {
    const rotation = [0, Math.SQRT1_2, 0, Math.SQRT1_2] as const;
    const moved = { position: [3, 2, 1], rotation, scale: 2 } as const;
    const { sceneFromCharacter, scale } = displayTransform(character, {
      transform: moved,
      fitted: false,
    });
    expect(scale).toBe(2);
    const expected = multiply(translation(moved.position), rotationOf(rotation));
    for (let row = 0; row < 3; row++) {
      for (let column = 0; column < 4; column++) {
        const factor = column < 3 ? 2 : 1;
        expect(sceneFromCharacter[column * 4 + row]).toBeCloseTo(
          expected[row]![column]! * factor,
          12,
        );
      }
    }
    const own = displayTransform(character, { fitted: false });
    expect([...own.sceneFromCharacter]).toEqual([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    expect(displayTransform(character).scale).not.toBe(1);
  });
});

it('a copy stands beside everything, as high and as deep as its original', () => {
  const placed = { ...unmoved, position: [-4, 0.5, 2], scale: 3 } as const;
  const original = new Evaluator(edited(posed, setTransform(id, placed, 'Place')));
  const taken = { min: Float64Array.of(-9, 0, -1), max: Float64Array.of(2, 1, 1) };
  const copy = placeBeside(taken, original);
  expect({ ...copy, position: copy.position.slice(1) }).toEqual({ ...placed, position: [0.5, 2] });
  const shown = new Evaluator({ ...original.state, transform: copy });
  expect(sceneBounds([shown]).min[0]).toBeCloseTo(2.2, 9);
});
