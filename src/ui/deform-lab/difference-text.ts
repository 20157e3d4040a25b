import type { CharacterSize } from '../../evaluation/comparison/difference.ts';
import { formatSize } from '../number-text.ts';

/** A length in the character's units and in per cent of its height: "0.043 (2.4 %)". */
export function differenceText(length: number, size: CharacterSize): string {
  return `${formatSize(length)} (${percentText(length, size)})`;
}

/** A length as a part of the character's height: "2.4 %". */
export function percentText(length: number, { height }: CharacterSize): string {
  const percent = (100 * length) / height;
  if (percent === 0) return '0 %';
  return percent < 0.01 ? '< 0.01 %' : `${Number(percent.toPrecision(2))} %`;
}
