import { subtract, unit, type Vector3 } from '../vector.ts';

/** Goal units a meter: a place that is a centimeter off counts as much as a turn of a tenth. */
const PER_METER = 10;

export function at(place: Vector3, wanted: Vector3, weight = 1): number[] {
  return subtract(place, wanted).map((value) => value * PER_METER * weight);
}

/** Only those coordinates that are given are wanted. */
export function near(
  place: Vector3,
  wanted: { readonly x?: number; readonly y?: number; readonly z?: number },
  weight = 1,
): number[] {
  return (['x', 'y', 'z'] as const).flatMap((axis, index) => {
    const value = wanted[axis];
    return value === undefined ? [] : [(place[index]! - value) * PER_METER * weight];
  });
}

export function along(direction: Vector3, wanted: Vector3, weight = 1): number[] {
  return subtract(unit(direction), unit(wanted)).map((value) => value * weight);
}

/** On the floor, neither above nor below it. */
export function onFloor(bottom: number): number {
  return bottom * PER_METER * 8;
}

/** Not below the floor. */
export function aboveFloor(bottom: number): number {
  return Math.min(bottom, 0) * PER_METER * 8;
}
