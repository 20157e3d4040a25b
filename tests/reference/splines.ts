import type { Extrapolation, KeyParts, Tangent } from '../../src/core/motion/clip-parts.ts';

// Splines written apart from the product's: spans are Bézier curves by de Casteljau's construction,
// slopes come from divided differences, and quaternions are w x y z.

/** The value of a curve of numbers at a time. */
export function curveValue(
  keys: readonly KeyParts[],
  rules: { readonly before: Extrapolation; readonly after: Extrapolation },
  time: number,
): number {
  const [first, last] = [keys[0], keys.at(-1)];
  if (!first || !last) return 0;
  if (keys.length === 1) return first.value;
  if (time >= first.time && time <= last.time) return spanValue(keys, time);
  const isBefore = time < first.time;
  const rule = isBefore ? rules.before : rules.after;
  if (rule === 'constant') return isBefore ? first.value : last.value;
  if (rule === 'linear') {
    const [key, at] = isBefore ? [first, 0] : [last, keys.length - 1];
    return key.value + slope(keys, at, isBefore ? 'in' : 'out') * (time - key.time);
  }
  // Walks into the keys by whole periods, one at a time.
  const period = last.time - first.time;
  let [moved, cycles] = [time, 0];
  for (; moved > last.time; moved -= period) cycles++;
  for (; moved < first.time; moved += period) cycles--;
  if (rule === 'bounce' && cycles % 2 !== 0) moved = first.time + last.time - moved;
  const value = spanValue(keys, moved);
  return rule === 'cycle_offset' ? value + cycles * (last.value - first.value) : value;
}

function spanValue(keys: readonly KeyParts[], time: number): number {
  const after = Math.max(
    1,
    keys.findIndex((key) => key.time > time),
  );
  const at = keys.at(-1)!.time <= time ? keys.length - 1 : after;
  const [a, b] = [keys[at - 1]!, keys[at]!];
  if (time === b.time) return b.value;
  if (a.tangentOut === 'stepped' || b.tangentIn === 'stepped') return a.value;
  const third = (b.time - a.time) / 3;
  let points = [
    a.value,
    a.value + third * slope(keys, at - 1, 'out'),
    b.value - third * slope(keys, at, 'in'),
    b.value,
  ];
  const u = (time - a.time) / (b.time - a.time);
  while (points.length > 1) {
    points = points.slice(1).map((point, i) => (1 - u) * points[i]! + u * point);
  }
  return points[0]!;
}

function slope(keys: readonly KeyParts[], at: number, side: 'in' | 'out'): number {
  const tangent: Tangent = side === 'in' ? keys[at]!.tangentIn : keys[at]!.tangentOut;
  if (typeof tangent === 'number') return tangent;
  if (tangent === 'flat' || tangent === 'stepped') return 0;
  const span = (i: number): number => keys[i + 1]!.time - keys[i]!.time;
  const secant = (i: number): number => (keys[i + 1]!.value - keys[i]!.value) / span(i);
  const isEnd = at === 0 || at === keys.length - 1;
  const only = at === 0 ? 0 : at - 1;
  if (tangent === 'linear') return isEnd ? secant(only) : secant(side === 'in' ? at - 1 : at);
  if (tangent === 'smooth') {
    const [a, b] = [keys[at - 1], keys[at + 1]];
    return a && b ? (b.value - a.value) / (b.time - a.time) : secant(only);
  }
  if (tangent === 'auto') {
    if (isEnd) return monotoneEnd(keys.length, at === 0, span, secant);
    const [before, after] = [secant(at - 1), secant(at)];
    if (before * after <= 0) return 0;
    // Brodlie's form of the harmonic mean.
    const share = (span(at - 1) + 2 * span(at)) / (3 * (span(at - 1) + span(at)));
    return (before * after) / (share * after + (1 - share) * before);
  }
  const [tension, continuity, bias] = tangent.tcb;
  if (isEnd) return (1 - tension) * secant(only);
  const [before, after] = [
    keys[at]!.value - keys[at - 1]!.value,
    keys[at + 1]!.value - keys[at]!.value,
  ];
  const sign = side === 'out' ? 1 : -1;
  // By the parameter of the span, then of the time.
  const own = span(side === 'out' ? at : at - 1);
  const byParameter =
    0.5 * (1 - tension) * (1 + sign * continuity) * (1 + bias) * before +
    0.5 * (1 - tension) * (1 - sign * continuity) * (1 - bias) * after;
  return (byParameter * 2 * own) / (span(at - 1) + span(at)) / own;
}

/** The slope of the parabola through the three keys at an end, limited. */
function monotoneEnd(
  count: number,
  isFirst: boolean,
  span: (i: number) => number,
  secant: (i: number) => number,
): number {
  const [own, next] = isFirst ? [0, 1] : [count - 2, count - 3];
  if (count === 2) return secant(0);
  const bend = (secant(next) - secant(own)) / (span(own) + span(next));
  const parabola = secant(own) - span(own) * bend;
  if (Math.sign(parabola) !== Math.sign(secant(own))) return 0;
  const turns = Math.sign(secant(own)) !== Math.sign(secant(next));
  return turns && Math.abs(parabola) > 3 * Math.abs(secant(own)) ? 3 * secant(own) : parabola;
}

/** w x y z */
export type Wxyz = readonly [number, number, number, number];

/** The rotation of a squad at a time between its keys. */
export function squadRotation(
  keys: readonly { readonly time: number; readonly value: Wxyz }[],
  time: number,
): Wxyz {
  const fixed: Wxyz[] = [];
  for (const { value } of keys) {
    const former = fixed.at(-1);
    fixed.push(former && dot(former, value) < 0 ? scaled(value, -1) : value);
  }
  const control = (i: number): Wxyz => {
    const [former, own, next] = [fixed[i - 1], fixed[i]!, fixed[i + 1]];
    if (!former || !next) return own;
    const [a, b] = [log(times(conjugate(own), next)), log(times(conjugate(own), former))];
    return times(own, exp(scaled(sum(a, b), -0.25)));
  };
  const after = keys.findIndex((key) => key.time > time);
  const i = (after < 0 ? keys.length - 1 : Math.max(1, after)) - 1;
  const h = (time - keys[i]!.time) / (keys[i + 1]!.time - keys[i]!.time);
  const arc = along(fixed[i]!, fixed[i + 1]!, h);
  return along(arc, along(control(i), control(i + 1), h), 2 * h * (1 - h));
}

/** The turn between two rotations, in radians: twice the arc sine of half their chord. */
export function turnBetween(a: Wxyz, b: Wxyz): number {
  const chord = (sign: number): number => Math.hypot(...sum(a, scaled(b, sign)));
  return 4 * Math.asin(Math.min(1, Math.min(chord(1), chord(-1)) / 2));
}

/** a · (a⁻¹ · b)ʰ */
function along(a: Wxyz, b: Wxyz, h: number): Wxyz {
  return times(a, exp(scaled(log(times(conjugate(a), b)), h)));
}

function log([w, x, y, z]: Wxyz): Wxyz {
  const length = Math.hypot(x, y, z);
  const factor = length === 0 ? 0 : Math.atan2(length, w) / length;
  return [0, x * factor, y * factor, z * factor];
}

function exp([, x, y, z]: Wxyz): Wxyz {
  const length = Math.hypot(x, y, z);
  const factor = length === 0 ? 1 : Math.sin(length) / length;
  return [Math.cos(length), x * factor, y * factor, z * factor];
}

function times([a, b, c, d]: Wxyz, [e, f, g, h]: Wxyz): Wxyz {
  return [
    a * e - b * f - c * g - d * h,
    a * f + b * e + c * h - d * g,
    a * g - b * h + c * e + d * f,
    a * h + b * g - c * f + d * e,
  ];
}

function conjugate([w, x, y, z]: Wxyz): Wxyz {
  return [w, -x, -y, -z];
}

function scaled([w, x, y, z]: Wxyz, factor: number): Wxyz {
  return [w * factor, x * factor, y * factor, z * factor];
}

function sum([a, b, c, d]: Wxyz, [e, f, g, h]: Wxyz): Wxyz {
  return [a + e, b + f, c + g, d + h];
}

function dot(a: Wxyz, b: Wxyz): number {
  return a.reduce((total, value, i) => total + value * b[i]!, 0);
}
