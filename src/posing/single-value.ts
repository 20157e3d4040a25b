import { vec3 } from 'gl-matrix';
import type { Ray } from '../core/ray.ts';
import { DofKind } from '../core/skeleton.ts';
import type { DofFrame } from './joint-frames.ts';

const turn = 2 * Math.PI;
/** The number of samples on a circle in the search for the points nearest to a ray. */
const samples = 72;
/**
 * The cost of half a turn away from the start, as a fraction of the squared radius. It decides only
 * between points that are about equally near, such as the front and the back of a circle seen
 * edge-on.
 */
const pull = 0.02;

/** A hinge or slide that is dragged on its own. */
export interface SingleDof {
  readonly dof: DofFrame;
  /** Its value at the start, and its limits. */
  readonly value: number;
  readonly min: number;
  readonly max: number;
}

/** The distance of a point from a hinge's axis: the radius at which a drag rotates it. */
export function radiusAbout({ axis, origin }: DofFrame, point: vec3): number {
  return vec3.length(across(vec3.subtract(new Float64Array(3), point, origin), axis));
}

/**
 * Returns the value, within the limits, that brings a point nearest to a ray while all other values
 * stay as at the start. For a hinge, the equivalent value nearest to `near` is taken.
 *
 * @param point its position at the start, in the character's space
 */
export function nearestValue(single: SingleDof, point: vec3, ray: Ray, near: number): number {
  return single.dof.kind === DofKind.hinge
    ? nearestAngle(single, point, ray, near)
    : nearestOffset(single, point, ray);
}

function nearestOffset({ dof, value, min, max }: SingleDof, point: vec3, ray: Ray): number {
  const direction = across(dof.axis, ray.direction);
  const length = vec3.dot(direction, direction);
  if (length < 1e-12) return value; // the axis points at the viewer, so the ray determines nothing
  const gap = vec3.subtract(new Float64Array(3), ray.origin, point);
  return clamp(value + vec3.dot(gap, direction) / length, min, max);
}

/**
 * The squared distance of the circle's point c + u cos φ + v sin φ from the ray has up to two
 * minima. They are found by the sign of its derivative and bisection. With limits, the ends of the
 * range are candidates too.
 */
function nearestAngle(single: SingleDof, point: vec3, ray: Ray, near: number): number {
  const { dof, value, min, max } = single;
  const arm = vec3.subtract(new Float64Array(3), point, dof.origin);
  const u = across(arm, dof.axis);
  const radius = vec3.dot(u, u);
  const v = vec3.cross(new Float64Array(3), dof.axis, u);
  const center = vec3.subtract(new Float64Array(3), vec3.subtract(arm, arm, u), ray.origin);
  vec3.add(center, center, dof.origin);
  // All vectors projected along the ray.
  const [m, p, s] = [center, u, v].map((vector) => across(vector, ray.direction));
  const [mp, ms, ps] = [vec3.dot(m!, p!), vec3.dot(m!, s!), vec3.dot(p!, s!)];
  const bend = vec3.dot(s!, s!) - vec3.dot(p!, p!);

  const slope = (angle: number): number => {
    const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
    return ms * cos - mp * sin + bend * sin * cos + ps * (cos * cos - sin * sin);
  };
  const cost = (angle: number): number => {
    const seen = vec3.scaleAndAdd(new Float64Array(3), m!, p!, Math.cos(angle));
    vec3.scaleAndAdd(seen, seen, s!, Math.sin(angle));
    return vec3.dot(seen, seen) + (pull * radius * (1 - Math.cos(angle))) / 2;
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

/**
 * The angle plus the full turns that bring it nearest to `near` within the limits, or null if none
 * do.
 */
function equivalentWithin(angle: number, near: number, min: number, max: number): number | null {
  const lowest = Math.ceil((min - angle) / turn);
  const highest = Math.floor((max - angle) / turn);
  if (lowest > highest) return null;
  return angle + turn * clamp(Math.round((near - angle) / turn), lowest, highest);
}

/** Bisection: where the function, negative at `low` and not negative at `high`, crosses zero. */
function halve(slope: (angle: number) => number, low: number, high: number): number {
  for (let step = 0; step < 60; step++) {
    const middle = (low + high) / 2;
    if (slope(middle) < 0) low = middle;
    else high = middle;
  }
  return high;
}

/** The component of a vector that is perpendicular to a unit direction. */
function across(vector: vec3, direction: ArrayLike<number>): vec3 {
  const unit = direction as vec3;
  return vec3.scaleAndAdd(new Float64Array(3), vector, unit, -vec3.dot(vector, unit));
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(max, Math.max(min, value));
}
