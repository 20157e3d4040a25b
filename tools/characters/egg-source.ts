import { readFileSync } from 'node:fs';
import { inflateSync } from 'node:zlib';
import { mat4 } from 'gl-matrix';

/** `<TYPE> NAME { … }`: words and further nodes in any order. */
export interface EggNode {
  readonly type: string;
  readonly name: string;
  readonly words: string[];
  readonly children: EggNode[];
}

const token = /\/\/[^\n]*|"(?<quoted>[^"]*)"|<(?<type>[^>]*)>|(?<brace>[{}])|(?<word>[^\s{}<"]+)/g;

/** Reads a file of Panda3D, compressed (`.egg.pz`), and returns its nodes as children of one. */
export function readEgg(path: string): EggNode {
  const root = { type: '', name: '', words: [], children: [] };
  const open: EggNode[] = [root];
  let next: { type: string; name: string } | undefined;
  for (const { groups = {} } of inflateSync(readFileSync(path)).toString('utf8').matchAll(token)) {
    const { type, brace } = groups;
    const word = groups['quoted'] ?? groups['word'];
    if (type !== undefined) next = { type, name: '' };
    else if (brace === '{') {
      const node: EggNode = { type: '', name: '', ...next, words: [], children: [] };
      next = undefined;
      open.at(-1)!.children.push(node);
      open.push(node);
    } else if (brace === '}') open.pop();
    else if (word !== undefined && next) next.name = word;
    else if (word !== undefined) open.at(-1)!.words.push(word);
  }
  return root;
}

/** All nodes of a type, at any depth, in the order of the file. */
export function nodesOf(node: EggNode, type: string): EggNode[] {
  return node.children.flatMap((child) => [
    ...(child.type === type ? [child] : []),
    ...nodesOf(child, type),
  ]);
}

export function childOf(node: EggNode, type: string, name?: string): EggNode | undefined {
  return node.children.find(
    (child) => child.type === type && (name === undefined || child.name === name),
  );
}

export function numbersOf(node: EggNode | undefined): number[] {
  return (node?.words ?? []).map(Number);
}

/**
 * Returns the local matrix of a table at a frame. The file multiplies rows by matrices, so its
 * numbers in order are those of a column-major matrix. Scale comes first, then pitch about x, heading
 * about z and roll about -y, then the translation.
 */
export function matrixAt(table: EggNode, frame: number): mat4 {
  const channels = childOf(table, 'Xfm$Anim_S$')!;
  const at = (name: string, otherwise: number): number => {
    const channel = childOf(channels, 'S$Anim', name);
    const values = numbersOf(channel && childOf(channel, 'V'));
    return values[Math.min(frame, values.length - 1)] ?? otherwise;
  };
  const angle = (name: string): number => (at(name, 0) * Math.PI) / 180;
  const matrix: mat4 = new Float64Array(16);
  mat4.fromTranslation(matrix, [at('x', 0), at('y', 0), at('z', 0)]);
  mat4.rotateY(matrix, matrix, -angle('r'));
  mat4.rotateZ(matrix, matrix, angle('h'));
  mat4.rotateX(matrix, matrix, angle('p'));
  return mat4.scale(matrix, matrix, [at('i', 1), at('j', 1), at('k', 1)]);
}
