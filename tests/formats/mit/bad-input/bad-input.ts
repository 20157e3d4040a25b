import type { FileContents } from '../../../support/files.ts';
import type { Left } from '../../bad-input.ts';

export type { BadInput, Left } from '../../bad-input.ts';

const skel = '0 0 0 -1\n0 1 0 0\n0 1 0 1\n';
export const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';
const obj = `${square}f 1 2 3\nf 1 3 4\n`;
const attach = '1 0\n0.25 0.75\n0 1\n1 0\n';

/** A valid character: three joints in a row, a square, two columns of weights. */
export const whole: FileContents = { 'a.skel': skel, 'a.obj': obj, 'a.attach': attach };

export const all: Left = { joints: 3, vertices: 4, triangles: 2, bound: true };
export const meshOnly: Left = { ...all, joints: 0, bound: false };
export const unbound: Left = { ...all, bound: false };
export const skeletonOnly: Left = { joints: 3, vertices: 0, triangles: 0, bound: false };

/** The valid character with another `.skel`. */
export function withSkel(content: string | Uint8Array): FileContents {
  return { ...whole, 'a.skel': content };
}

/** The valid skeleton with another `.obj`, without weights. */
export function withObj(content: string | Uint8Array): FileContents {
  return { 'a.skel': skel, 'a.obj': content };
}

/** The valid character with another `.attach`. */
export function withAttach(content: string | Uint8Array): FileContents {
  return { ...whole, 'a.attach': content };
}
