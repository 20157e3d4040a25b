import type { Diagnostic } from '../../core/diagnostics.ts';
import { type ClipParts, defaultFps } from '../../core/motion/clip-parts.ts';
import { lost } from '../lost.ts';
import { atMost } from '../motion/largest-between.ts';
import type { PlainCurve } from './plain-tangents.ts';

/** Collects what an `.anim` can't hold. */
export class AnimLosses {
  private readonly file: string;
  private readonly clip: ClipParts;
  private readonly turns: number[] = [];
  private readonly curves: PlainCurve[] = [];

  constructor(file: string, clip: ClipParts) {
    this.file = file;
    this.clip = clip;
  }

  /** @param largest radians between a rotation and the angles in its place */
  rotation(largest: number): void {
    this.turns.push(largest);
  }

  curve(curve: PlainCurve): void {
    this.curves.push(curve);
  }

  losses(): readonly Diagnostic[] {
    const { channels, unread = [], fps } = this.clip;
    const found: Diagnostic[] = [];
    const lose = (expected: string, what: string, effect: string): void => {
      found.push(lost(this.file, expected, what, effect));
    };
    const sum = (of: (curve: PlainCurve) => number): number =>
      this.curves.reduce((total, curve) => total + of(curve), 0);
    const fixed = sum((curve) => curve.fixed);
    if (fixed > 0) {
      const change = Math.max(...this.curves.map((curve) => curve.change));
      const effect = `they are fixed slopes; the largest change of value is ${atMost(change)}`;
      lose('tangents flat, linear, smooth or fixed', `${fixed} others`, effect);
    }
    const steps = sum((curve) => curve.steps);
    if (steps > 0) {
      const jump = Math.max(...this.curves.map((curve) => curve.jump));
      const effect = `each jump takes 1 ms; the largest is ${short(jump)}`;
      lose('spans without jumps', `${steps} stepped spans`, effect);
    }
    if (this.turns.length > 0) {
      const degrees = (Math.max(...this.turns) * 180) / Math.PI;
      const effect = `sampled at ${short(fps)} frames a second; off by at most ${atMost(degrees)}° between them`;
      lose('angles of joints', `${this.turns.length} rotations`, effect);
    }
    const morphs = channels.filter(({ target }) => target?.of === 'morph').length;
    if (morphs > 0) lose('channels of joints', `${morphs} of morphs`, 'they are left out');
    const pins = channels.filter(({ target }) => target?.of === 'pin').length;
    if (pins > 0) lose('channels of joints', `${pins} of pins`, 'they are left out');
    if (unread.length > 0) {
      lose('channels of joints', `${unread.length} that Sinew can't use`, 'they are left out');
    }
    if (fps !== defaultFps) {
      lose('no rate of frames', `${short(fps)} a second`, `it is ${defaultFps} when it is read`);
    }
    return found;
  }
}

function short(value: number): string {
  return String(Number(value.toPrecision(2)));
}
