import type { Character } from '../../../../src/core/character.ts';
import type { FileContents } from '../../../support/files.ts';
import type { BadInput, Left } from '../../bad-input.ts';

export type { BadInput, Left } from '../../bad-input.ts';

const skel = 'balljoint a {\n}\n';

/** The sections of a valid skin, a triangle on one joint, one per line. */
export const sections = {
  positions: 'positions 3 { 0 0 0 1 0 0 0 1 0 }',
  normals: 'normals 3 { 0 0 1 0 0 1 0 0 1 }',
  skinweights: 'skinweights 3 { 1 0 1 1 0 1 1 0 1 }',
  triangles: 'triangles 1 { 0 1 2 }',
  bindings: 'bindings 1 { matrix { 1 0 0 0 1 0 0 0 1 0 0 0 } }',
};

/** The valid skin with some of its sections replaced, and more text at its end. */
export function skinText(changed: Partial<typeof sections> = {}, more = ''): string {
  return [...Object.values({ ...sections, ...changed }), more].join('\n');
}

/** A valid character: a joint and a triangle that follows it. */
export const whole: FileContents = { 'a.skel': skel, 'a.skin': skinText() };

export const all: Left = { joints: 1, vertices: 3, triangles: 1, bound: true };
export const unbound: Left = { ...all, bound: false };
export const meshOnly: Left = { ...all, joints: 0, bound: false };
export const skeletonOnly: Left = { joints: 1, vertices: 0, triangles: 0, bound: false };

/** A skeleton that is refused; its message follows "error: a.skel". */
export function noSkel(title: string, text: string | Uint8Array, message: string): BadInput {
  return {
    title,
    files: { ...whole, 'a.skel': text },
    messages: [`error: a.skel${message}; the skeleton is not used`],
    left: meshOnly,
  };
}

/** A skeleton alone that is read, possibly with warnings; each follows "warning: a.skel". */
export function readSkeleton(
  title: string,
  text: string | Uint8Array,
  warnings: readonly string[],
  joints = 1,
  check?: (character: Character) => void,
): BadInput {
  return {
    title,
    files: { 'a.skel': text },
    messages: warnings.map((warning) => `warning: a.skel${warning}`),
    left: { ...skeletonOnly, joints },
    ...(check ? { check } : {}),
  };
}

/** A skin that is refused. */
export function noSkin(title: string, text: string, message: string): BadInput {
  return {
    title,
    files: { ...whole, 'a.skin': text },
    messages: [`error: a.skin${message}; the mesh is not used`],
    left: skeletonOnly,
  };
}

/** A skin that is read, possibly with warnings. */
export function readSkinOf(
  title: string,
  text: string,
  warnings: readonly string[],
  check?: (character: Character) => void,
): BadInput {
  return {
    title,
    files: { ...whole, 'a.skin': text },
    messages: warnings.map((warning) => `warning: a.skin${warning}`),
    left: all,
    ...(check ? { check } : {}),
  };
}
