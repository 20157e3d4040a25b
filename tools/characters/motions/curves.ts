/** A time in seconds and a value, in radians or meters. */
export type Key = readonly [time: number, value: number];

/** A value that stays, or the keys of a curve. */
export type Curve = number | readonly Key[];

/** The three angles of a joint, about x, y and z. */
export type Turn = readonly [x: Curve, y: Curve, z: Curve];

/** How a character moves: the angles of joints by their names, and where its root goes. */
export interface Design {
  readonly joints: Readonly<Record<string, Turn>>;
  readonly root?: { readonly name: string; readonly place: Turn };
  /** In seconds. */
  readonly length: number;
  /** Whether it goes on from its end as from its start; otherwise it ends at rest. */
  readonly isCycle: boolean;
}

/** What is written of a design. */
export interface MotionJson {
  readonly version: 1;
  readonly fps: number;
  readonly range: readonly [number, number];
  readonly channels: readonly unknown[];
}

/** Decimals of a written time and value. */
const decimals = 4;

/** Returns the design in the form of MOTION.json. */
export function motionJson({ joints, root, length, isCycle }: Design): MotionJson {
  const turns = Object.entries(joints).flatMap(([joint, turn]) =>
    channels(joint, ['rx', 'ry', 'rz'], turn),
  );
  const places = root ? channels(root.name, ['tx', 'ty', 'tz'], root.place) : [];
  return { version: 1, fps: 30, range: [0, round(length)], channels: [...places, ...turns] };

  function channels(joint: string, values: readonly string[], curves: Turn): unknown[] {
    return curves.map((curve, at) => {
      const target = { joint, value: values[at]! };
      if (typeof curve === 'number') return { target, keys: [[0, round(curve)]] };
      const keys = curve.map(([time, value]) => [round(time), round(value)] as const);
      if (!isCycle) return { target, keys: keys.map((key) => atRest(key, keys)) };
      const slope = round(cycleSlope(keys));
      const ends = keys.map((key, i) =>
        i === 0 || i === keys.length - 1 ? [...key, slope, slope] : key,
      );
      return { target, extrapolate: ['cycle', 'cycle'], keys: ends };
    });
  }
}

/** A motion that is no cycle begins and ends without speed. */
function atRest(key: Key, keys: readonly Key[]): unknown {
  return key === keys[0] || key === keys.at(-1) ? [...key, 'flat', 'flat'] : key;
}

/** The slope at both ends of a cycle, as the automatic tangent has it between keys. */
function cycleSlope(keys: readonly Key[]): number {
  const [[t0, v0], [t1, v1]] = [keys[0]!, keys[1]!];
  const [[t2, v2], [t3, v3]] = [keys.at(-2)!, keys.at(-1)!];
  const [spanIn, spanOut] = [t3 - t2, t1 - t0];
  const [slopeIn, slopeOut] = [(v3 - v2) / spanIn, (v1 - v0) / spanOut];
  if (slopeIn * slopeOut <= 0) return 0;
  const [weightIn, weightOut] = [2 * spanOut + spanIn, spanOut + 2 * spanIn];
  return (weightIn + weightOut) / (weightIn / slopeIn + weightOut / slopeOut);
}

/** A cycle through values at equal parts of its length. */
export function cycle(length: number, values: readonly number[]): readonly Key[] {
  return [...values, values[0]!].map((value, at) => [(at * length) / values.length, value]);
}

/** The same curve, half a cycle later; its values are at an even number of equal parts. */
export function halfLater(curve: Curve, length: number): Curve {
  if (typeof curve === 'number') return curve;
  const values = curve.slice(0, -1).map(([, value]) => value);
  const half = values.length / 2;
  return cycle(length, [...values.slice(half), ...values.slice(0, half)]);
}

/** The turn of the same joint on the other side: x is the same, y and z are opposite. */
export function mirrored([x, y, z]: Turn): Turn {
  return [x, negative(y), negative(z)];
}

function negative(curve: Curve): Curve {
  if (typeof curve === 'number') return -curve;
  return curve.map(([time, value]) => [time, -value]);
}

function round(value: number): number {
  return Number(value.toFixed(decimals)) + 0;
}
