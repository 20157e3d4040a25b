import { vec3 } from 'gl-matrix';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import { createActor } from '../../src/document/scene.ts';
import type { Evaluation } from '../../src/evaluation/evaluation.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import {
  fromNatural,
  naturalSkeleton,
  toNatural,
} from '../../src/posing/natural/natural-skeleton.ts';
import { type NatureSettings, plainNatures } from '../../src/posing/natural/nature-settings.ts';
import { naturesOf } from '../../src/posing/natural/natures.ts';
import { startCamera } from '../../src/view/camera.ts';
import { type NatureArc, natureArcs } from '../../src/view/nature-arcs.ts';
import { natureShapes } from '../../src/view/nature-shapes.ts';
import { isFace, pixelSizeAt } from '../../src/view/overlay.ts';
import { palette } from '../../src/view/theme.ts';
import { readBundled } from '../support/bundled.ts';
import { randomBetween, randomSource } from '../support/random.ts';

/** How far two unit vectors may be apart: a nature's axes are found in float32. */
const tolerance = 1e-7;
const radius = 54;
const view = { camera: startCamera, width: 1000, height: 800 };
const transform = { position: [0.1, 0, -0.2], rotation: [0, 0.6, 0, 0.8], scale: 1.3 } as const;

/** The soft range of sideways bends of an elbow is too narrow to be shown, unless it is changed. */
const wideSide = [-0.5, 0.4] as const;

let character: Character;
beforeAll(async () => {
  character = await readBundled('human');
});

/** Joints, and those where their limbs end. */
const limbs = [
  ['Left forearm', 'Left hand'],
  ['Right lower leg', 'Right foot'],
] as const;

describe.each(limbs)('the soft ranges of %s', (name, endName) => {
  const indexOf = (wanted: string): number => character.skeleton.names.indexOf(wanted);
  const found = () => naturesOf(character).find(({ joint }) => joint === indexOf(name))!;
  const widened = (): NatureSettings => {
    const { joint, stiffness, bend, twist } = found();
    return { isOn: true, own: [{ joint, stiffness, bend, side: wideSide, twist }] };
  };

  function evaluated(q: Float64Array, natures: NatureSettings = widened()): Evaluation {
    return new Evaluator(createActor(1, character, 'linear-blend', { q, transform, natures }));
  }

  function arcsOf(evaluation: Evaluation): Partial<Record<NatureArc['name'], NatureArc>> {
    const arcs = natureArcs(evaluation, view, { joint: indexOf(name), radius });
    return Object.fromEntries(arcs.map((each) => [each.name, each]));
  }

  /** A random pose, where a joint has these angles of bend, side and twist. */
  function posed(seed: number, angles?: readonly number[]): Float64Array {
    const random = randomSource(seed);
    const q = character.skeleton.qRest.map((value) => value + randomBetween(random, -0.7, 0.7));
    if (!angles) return q;
    const natural = naturalSkeleton(character.skeleton, [found()]);
    const start = toNatural(natural, q);
    const values = start.slice();
    values.set(angles, natural.joints[0]!.index);
    return fromNatural(natural, values, start, q);
  }

  /** The direction of the limb in the scene by the places of its joints. */
  function limbOf({ characterFromJoint, display }: Evaluation): vec3 {
    const [from, to] = [name, endName].map((each) => {
      const at = indexOf(each) * 16 + 12;
      const place = characterFromJoint.slice(at, at + 3);
      return vec3.transformMat4(new Float64Array(3), place, display.sceneFromCharacter);
    });
    return unit(vec3.subtract(new Float64Array(3), to!, from!));
  }

  it('mark the bend that the places of the joints tell, in any pose', () => {
    const angles: number[] = [];
    for (let seed = 0; seed < 8; seed++) {
      const evaluation = evaluated(posed(seed));
      const { bend, side } = arcsOf(evaluation);
      const limb = limbOf(evaluation);
      // The bend is where the limb is, as seen along the axis of bending.
      const [first, second] = [unit(bend!.first), unit(bend!.second)];
      const seen = Math.atan2(vec3.dot(limb, second), vec3.dot(limb, first));
      expect(Math.abs(seen - bend!.value)).toBeLessThan(tolerance);
      // And the limb itself is at the mark of the side.
      expect(vec3.distance(directionAt(side!, side!.value), limb)).toBeLessThan(tolerance);
      angles.push(seen);
    }
    expect(Math.max(...angles) - Math.min(...angles)).toBeGreaterThan(0.5);
  });

  it('end where the limb is when it is bent to the ends of the range', () => {
    for (const [end, angle] of found().bend.entries()) {
      const evaluation = evaluated(posed(3, [angle, 0, 0]));
      const { bend } = arcsOf(evaluation);
      expect(vec3.distance(directionAt(bend!, bend!.range[end]!), limbOf(evaluation))).toBeLessThan(
        tolerance,
      );
    }
    for (const [end, angle] of wideSide.entries()) {
      const evaluation = evaluated(posed(4, [0.8, angle, 0]));
      const { side } = arcsOf(evaluation);
      expect(vec3.distance(directionAt(side!, side!.range[end]!), limbOf(evaluation))).toBeLessThan(
        tolerance,
      );
    }
  });

  it('mark a twist that goes with the skin of the limb, on a ring that does not', () => {
    const twists = [0, 0.3, -0.9].map((angle) => evaluated(posed(5, [0.7, 0.1, angle])));
    const [without] = twists;
    for (const evaluation of twists) {
      const { twist } = arcsOf(evaluation);
      const rest = arcsOf(without!).twist!;
      expect(vec3.distance(unit(twist!.first), unit(rest.first))).toBeLessThan(tolerance);
      const mark = inJoint(evaluation, directionAt(twist!, twist!.value));
      const restMark = inJoint(without!, directionAt(rest, 0));
      expect(vec3.distance(mark, restMark)).toBeLessThan(tolerance);
    }

    function inJoint({ characterFromJoint, display }: Evaluation, direction: vec3): vec3 {
      const at = indexOf(name) * 16;
      const joint = characterFromJoint.subarray(at, at + 16);
      const m = display.sceneFromCharacter;
      return unit(
        [0, 1, 2].map((column) => {
          const axis = joint.subarray(column * 4, column * 4 + 3);
          const inScene = [0, 1, 2].map(
            (row) => m[row]! * axis[0]! + m[4 + row]! * axis[1]! + m[8 + row]! * axis[2]!,
          );
          return inScene.reduce((sum, value, row) => sum + value * direction[row]!, 0);
        }),
      );
    }
  });

  it('have one size in the picture, and leave out what tells nothing', () => {
    const evaluation = evaluated(posed(1));
    const { bend } = arcsOf(evaluation);
    const pixel = pixelSizeAt(view, bend!.center);
    for (const vector of [bend!.first, bend!.second]) {
      expect(vec3.length(vector) / pixel).toBeCloseTo(radius, 9);
    }
    // A sideways range of ±3° is left out.
    expect(arcsOf(evaluated(posed(1), plainNatures)).side).toBeUndefined();
    const free = { ...widened().own[0]!, bend: [-Math.PI, Math.PI] as const };
    expect(arcsOf(evaluated(posed(1), { isOn: true, own: [free] })).bend).toBeUndefined();
    expect(arcsOf(evaluated(posed(1), { isOn: false, own: [] }))).toEqual({});
  });

  it('have an orange mark where the bend is outside its range', () => {
    const [, most] = found().bend;
    const colors = [most - 0.1, most + 0.1].map((angle) => {
      const { bend } = arcsOf(evaluated(posed(2, [angle, 0, 0])));
      const shapes = natureShapes([bend!]);
      expect(shapes.filter(isFace).length).toBeGreaterThan(1);
      return shapes.at(-1)!.color;
    });
    expect(colors).toEqual([palette.hovered, palette.litBone]);
  });
});

function unit(vector: ArrayLike<number>): vec3 {
  const copy = Float64Array.of(vector[0]!, vector[1]!, vector[2]!);
  return vec3.normalize(copy, copy);
}

function directionAt({ first, second }: NatureArc, angle: number): vec3 {
  const point = vec3.scale(new Float64Array(3), first, Math.cos(angle));
  return unit(vec3.scaleAndAdd(point, point, second, Math.sin(angle)));
}
