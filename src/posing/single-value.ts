import { vec3 } from 'gl-matrix';
import type { Ray } from '../core/ray.ts';
import { DofKind } from '../core/skeleton.ts';
import type { DofFrame } from './joint-frames.ts';

const turn = 2 * Math.PI;
/** How finely a circle is looked over for the places nearest to a ray. */
const samples = 72;
/**
 * What half a turn away from the start costs, as a part of the radius squared: it decides only between
 * places that are about equally near, as front and back of a circle seen edge on.
 */
const pull = 0.02;

/** A hinge or slide that is dragged alone. */
export interface SingleDof {
  readonly dof: DofFrame;
  /** Its value at the start, and its limits. */
  readonly value: number;
  readonly min: number;
  readonly max: number;
}

/** How far a point is from a hinge's axis: the radius on which a drag turns it. */
export function radiusAbout({ axis, origin }: DofFrame, point: vec3): number {
  return vec3.length(across(vec3.subtract(new Float64Array(3), point, origin), axis));
}

/**
 * The value, within the limits, that brings a point nearest to a ray, all other values as at the
 * start; for a hinge of the equivalent ones that nearest to `near`.
 *
 * @param point where it is at the start, character space
 */
export function nearestValue(single: SingleDof, point: vec3, ray: Ray, near: number): number {
  return single.dof.kind === DofKind.hinge
    ? nearestAngle(single, point, ray, near)
    : nearestOffset(single, point, ray);
}

function nearestOffset({ dof, value, min, max }: SingleDof, point: vec3, ray: Ray): number {
  const direction = across(dof.axis, ray.direction);
  const length = vec3.squaredLength(direction);
  if (length < 1e-12) return value; // the axis points at the eye: nothing to go by
  const gap = vec3.subtract(new Float64Array(3), ray.origin, point);
  return clamp(value + vec3.dot(gap, direction) / length, min, max);
}

/**
 * The squared distance of the circle's point c + u cos φ + v sin φ from the ray has up to two minima:
 * they are found by the sign of its derivative and halved down. With limits their ends count too.
 */
function nearestAngle(single: SingleDof, point: vec3, ray: Ray, near: number): number {
  const { dof, value, min, max } = single;
  const arm = vec3.subtract(new Float64Array(3), point, dof.origin);
  const u = across(arm, dof.axis);
  const radius = vec3.squaredLength(u);
  const v = vec3.cross(new Float64Array(3), dof.axis, u);
  const center = vec3.subtract(new Float64Array(3), vec3.subtract(arm, arm, u), ray.origin);
  vec3.add(center, center, dof.origin);
  // Everything as seen along the ray.
  const [m, p, s] = [center, u, v].map((vector) => across(vector, ray.direction));
  const [mp, ms, ps] = [vec3.dot(m!, p!), vec3.dot(m!, s!), vec3.dot(p!, s!)];
  const bend = vec3.squaredLength(s!) - vec3.squaredLength(p!);

  const slope = (angle: number): number => {
    const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
    return ms * cos - mp * sin + bend * sin * cos + ps * (cos * cos - sin * sin);
  };
  const cost = (angle: number): number => {
    const seen = vec3.scaleAndAdd(new Float64Array(3), m!, p!, Math.cos(angle));
    vec3.scaleAndAdd(seen, seen, s!, Math.sin(angle));
    return vec3.squaredLength(seen) + (pull * radius * (1 - Math.cos(angle))) / 2;
  };

  const choices = [min, max].filter(Number.isFinite);
  for (let i = 0; i < samples; i++) {
    const [low, high] = [(i * turn) / samples, ((i + 1) * turn) / samples];
    if (!(slope(low) < 0 && slope(high) >= 0)) continue;
    const found = equivalentWithin(value + halve(slope, low, high), near, min, max);
    if (found !== null) choices.push(found);
  }
  return choices.reduce(
    (best, each) => (cost(each - value) < cost(best - value) ? each : best),
    choices[0] ?? near,
  );
}

/** The angle plus the whole turns that bring it nearest to `near` within the limits, if any do. */
function equivalentWithin(angle: number, near: number, min: number, max: number): number | null {
  const lowest = Math.ceil((min - angle) / turn);
  const highest = Math.floor((max - angle) / turn);
  if (lowest > highest) return null;
  return angle + turn * clamp(Math.round((near - angle) / turn), lowest, highest);
}

/** Where the function, negative at `low` and not at `high`, passes zero. */
function halve(slope: (angle: number) => number, low: number, high: number): number {
  for (let step = 0; step < 60; step++) {
    const middle = (low + high) / 2;
    if (slope(middle) < 0) low = middle;
    else high = middle;
  }
  return high;
}

/** What of a vector is across a unit direction. */
function across(vector: vec3, direction: ArrayLike<number>): vec3 {
  const unit = direction as vec3;
  return vec3.scaleAndAdd(new Float64Array(3), vector, unit, -vec3.dot(vector, unit));
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(max, Math.max(min, value));
}
