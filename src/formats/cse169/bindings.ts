import { mat3, mat4 } from 'gl-matrix';
import type { Scanner } from './scanner.ts';
import { closeRows, endsEarly } from './sections.ts';

/** A binding with a smaller determinant, or with a larger inverse, is treated as singular. */
const smallestDeterminant = 1e-12;
const largestInverse = 1e6;
const largestElement = 1e6;

export interface Bindings {
  readonly count: number;
  /**
   * (count × 16) column-major, as the file has them: from the joint's frame to the character's
   * space at bind time.
   */
  readonly bindFromJoint: Float64Array;
  /** (count × 16) their inverses. */
  readonly jointFromBind: Float64Array;
}

/**
 * Reads `J { matrix { … } … }`: four rows of three numbers per joint, the images of the x, y and z
 * axes and the translation. The rows of the file are therefore the columns of the matrix.
 */
export function readBindings(scanner: Scanner, most: number): Bindings | undefined {
  const count = scanner.count('bindings', 'matrix{}'.length + 24, most);
  if (!scanner.sound()) return undefined;
  const opened = scanner.openIfAny();
  const bindFromJoint = new Float64Array(count * 16);
  const jointFromBind = new Float64Array(count * 16);
  for (let joint = 0; joint < count; joint++) {
    if (endsEarly(scanner, 'bindings', count, joint)) return undefined;
    const bind = bindFromJoint.subarray(joint * 16, joint * 16 + 16);
    readMatrix(scanner, bind);
    if (scanner.sound()) {
      invert(scanner, joint, bind, jointFromBind.subarray(joint * 16, joint * 16 + 16));
    }
    if (!scanner.sound()) return undefined;
  }
  if (!closeBindings(scanner, count, opened)) return undefined;
  return { count, bindFromJoint, jointFromBind };
}

function closeBindings(scanner: Scanner, count: number, opened: boolean): boolean {
  const mark = scanner.reader.mark();
  const another = scanner.keyword(isMatrix) === 'matrix';
  if (another) scanner.fail('count', `${count} bindings, as the file says`, 'more');
  scanner.reader.back(mark);
  return scanner.sound() && closeRows(scanner, 'bindings', count, opened);
}

const isMatrix = (word: string): boolean => word === 'matrix';

function readMatrix(scanner: Scanner, bind: Float64Array): void {
  const { reader } = scanner;
  if (scanner.keyword(isMatrix) !== 'matrix') scanner.fail('token', '"matrix"');
  if (!scanner.sound() || !scanner.open()) return;
  const rows: number[] = [];
  for (;;) {
    const mark = reader.mark();
    reader.next();
    if (reader.isClose) break;
    reader.back(mark);
    const most = rows.length < 9 ? largestElement : undefined;
    rows.push(scanner.number('an element of the matrix', most));
    if (!scanner.sound()) return;
    if (rows.length > 12) break;
  }
  if (rows.length !== 12) {
    const found = rows.length > 12 ? '13 or more' : `${rows.length}`;
    scanner.fail('matrix', '12 numbers, 4 rows of 3', found);
    return;
  }
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 3; row++) bind[column * 4 + row] = rows[column * 3 + row]!;
  }
  bind[15] = 1;
}

function invert(scanner: Scanner, joint: number, bind: Float64Array, inverse: Float64Array): void {
  const determinant = mat3.determinant(mat3.fromMat4(new Float64Array(9), bind));
  const found = `determinant ${Number(determinant.toPrecision(3))}`;
  const inverted = Math.abs(determinant) >= smallestDeterminant && mat4.invert(inverse, bind);
  const fits =
    inverted && inverse.every((value, i) => i >= 12 || Math.abs(value) <= largestInverse);
  if (!fits) scanner.fail('singular', `a matrix with an inverse for joint ${joint}`, found);
  else if (determinant < 0) {
    const expected = `a matrix that does not mirror for joint ${joint}`;
    scanner.warn('mirrored', expected, found, 'it is used as it is');
  }
}
