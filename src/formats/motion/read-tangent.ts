import type { Tangent, Tcb } from '../../core/motion/clip-parts.ts';
import { defaultLimits } from '../../core/limits.ts';
import type { JsonValue } from '../json/decoder.ts';
import { isWithin, numberIn } from './fields.ts';

const rules = ['flat', 'linear', 'smooth', 'auto', 'stepped'] as const;
const expected = `a slope, one of ${rules.join(', ')}, or ["tcb", T, C, B]`;

/** A slope or the name of a rule; auto, if it is absent. Nothing for others, as by TCB. */
export function plainTangent(value: unknown = 'auto'): Tangent | undefined {
  if (isWithin(value, defaultLimits.coordinate)) return value;
  return rules.find((word) => word === value);
}

/** Reads the tangent on one side of a key: a slope in value per second, or a rule. */
export function readTangent(json: JsonValue): Tangent | undefined {
  const { value } = json;
  if (typeof value === 'number') return numberIn(json, defaultLimits.coordinate, 'a slope');
  const rule = rules.find((word) => word === value);
  if (rule !== undefined) return rule;
  if (Array.isArray(value) && value[0] === 'tcb' && value.length === 4) {
    const read = [1, 2, 3].map((at) =>
      numberIn(json.member(at), defaultLimits.weight, 'tension, continuity and bias'),
    );
    return read.includes(undefined) ? undefined : { tcb: read as unknown as Tcb };
  }
  json.fail('token', expected);
  return undefined;
}
