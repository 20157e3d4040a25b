/** Revisions grow over all stages of all evaluators. */
let latest = 0;

/** A value with what it is a function of; whoever has the same inputs holds the same cell. */
interface Cell<T> {
  inputs: readonly unknown[];
  revision: number;
  /** Stages that hold it. */
  users: number;
  /** Computed from the inputs; while it is stale, what was computed before, to be written again. */
  value: T | undefined;
  isStale: boolean;
}

/** The values of one kind of stage that the evaluators of one character hold between them. */
export class StageCells<T> {
  private readonly cells = new Set<Cell<T>>();
  /** Let go of last: whoever parts from a shared cell writes its arrays, so that none are made. */
  private spare: Cell<T> | undefined;

  /** How many different values are held. */
  get size(): number {
    return this.cells.size;
  }

  /** The cell of these inputs, in exchange for the one that was held before. */
  exchange(held: Cell<T> | undefined, inputs: readonly unknown[]): Cell<T> {
    for (const cell of this.cells) {
      if (!sameInputs(cell.inputs, inputs)) continue;
      cell.users++;
      if (held) this.release(held);
      return cell;
    }
    if (held?.users === 1) return renew(held, inputs);
    if (held) held.users--;
    const cell = renew(this.spare ?? emptyCell<T>(), inputs);
    this.spare = undefined;
    this.cells.add(cell);
    return cell;
  }

  release(cell: Cell<T>): void {
    if (--cell.users > 0) return;
    this.cells.delete(cell);
    this.spare = this.cells.size > 0 ? cell : undefined;
  }
}

/** A value that is computed when it is read and its inputs are not what they were. */
export class Stage<T> {
  private readonly cells: StageCells<T>;
  private readonly inputsNow: () => readonly unknown[];
  private readonly compute: (former: T | undefined) => T;
  private cell: Cell<T> | undefined;

  /**
   * @param cells shared with whoever computes the same from equal inputs
   * @param inputsNow what the value is a function of: arrays of float64 are compared by their bits, all
   *   else by identity
   * @param compute gets an earlier value that nobody reads any more, to write into it, if there is one
   */
  constructor(
    cells: StageCells<T>,
    inputsNow: () => readonly unknown[],
    compute: (former: T | undefined) => T,
  ) {
    this.cells = cells;
    this.inputsNow = inputsNow;
    this.compute = compute;
  }

  /** Stands for the inputs: equal ones have the same. To ask computes nothing. */
  get revision(): number {
    return this.current().revision;
  }

  get value(): T {
    const cell = this.current();
    if (cell.isStale || cell.value === undefined) {
      cell.value = this.compute(cell.value);
      cell.isStale = false;
    }
    return cell.value;
  }

  /** Lets go of the value; to read it again holds it again. */
  release(): void {
    if (this.cell) this.cells.release(this.cell);
    this.cell = undefined;
  }

  private current(): Cell<T> {
    const inputs = this.inputsNow();
    if (!this.cell || !sameInputs(this.cell.inputs, inputs)) {
      this.cell = this.cells.exchange(this.cell, inputs);
    }
    return this.cell;
  }
}

function emptyCell<T>(): Cell<T> {
  return { inputs: [], revision: 0, users: 0, value: undefined, isStale: true };
}

/** Gives a cell that nobody else holds to one user, with other inputs. */
function renew<T>(cell: Cell<T>, inputs: readonly unknown[]): Cell<T> {
  return Object.assign(cell, { inputs, revision: ++latest, users: 1, isStale: true });
}

function sameInputs(a: readonly unknown[], b: readonly unknown[]): boolean {
  return a.length === b.length && a.every((input, i) => sameInput(input, b[i]));
}

function sameInput(a: unknown, b: unknown): boolean {
  if (a === b || !(a instanceof Float64Array && b instanceof Float64Array)) return a === b;
  return a.length === b.length && a.every((value, i) => Object.is(value, b[i]));
}
