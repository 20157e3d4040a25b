/** The latest revision, which grows over all stages of all evaluators. */
let latest = 0;

/** A value with the inputs that determine it. Stages with the same inputs hold the same cell. */
interface Cell<T> {
  inputs: readonly unknown[];
  revision: number;
  /** The number of stages that hold the cell. */
  users: number;
  /**
   * This is computed from the inputs. While it is stale, it is an earlier value, to be overwritten.
   */
  value: T | undefined;
  isStale: boolean;
}

/** The values of one kind of stage that the evaluators of one character share. */
export class StageCells<T> {
  private readonly cells = new Set<Cell<T>>();
  /**
   * The cell that was released last. A stage that leaves a shared cell writes into its arrays, so
   * that no new ones are allocated.
   */
  private spare: Cell<T> | undefined;

  /** The number of different values that are held. */
  get size(): number {
    return this.cells.size;
  }

  /** Returns the cell for these inputs, in exchange for the one that was held before. */
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

/** A value that is computed when it is read, if its inputs have changed. */
export class Stage<T> {
  private readonly cells: StageCells<T>;
  private readonly inputsNow: () => readonly unknown[];
  private readonly compute: (former: T | undefined) => T;
  private cell: Cell<T> | undefined;

  /**
   * @param cells shared with every stage that computes the same from equal inputs
   * @param inputsNow returns what determines the value: arrays of float64 are compared by their
   *   bits, everything else by identity
   * @param compute gets an earlier value that is no longer read, if there is one, to write into it
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

  /**
   * A number that identifies the inputs: equal inputs have the same. Reading it computes nothing.
   */
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

  /** Releases the value; reading it acquires it again. */
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

/** Assigns other inputs to a cell that nobody else holds, with one user. */
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
