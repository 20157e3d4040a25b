import { printable } from '../core/diagnostics.ts';

/** Numbers repeated names ("human", "human 2"), so that copies can be told apart. */
export function numberedNames(names: readonly string[]): string[] {
  return names.map((name, index) => {
    const before = names.slice(0, index).filter((other) => other === name).length;
    return `${printable(name, 80)}${before === 0 ? '' : ` ${before + 1}`}`;
  });
}
