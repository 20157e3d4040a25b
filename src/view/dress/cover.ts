import type { UniformValue } from '../../gl/program.ts';

/** What covers a surface in place of one color. */
export interface Cover {
  /** The program of the mesh pass that draws it. */
  readonly program: string;
  /** What it sets in place of the material's own colors. */
  readonly uniforms: Readonly<Record<string, UniformValue>>;
  /** Binds its texture, if it has one. */
  bind(unit: number): void;
}
