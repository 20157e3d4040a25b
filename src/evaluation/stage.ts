/** Revisions grow over all stages of all evaluators. */
let latest = 0;

/** A value that is computed when it is read and its inputs are not what they were. */
export class Stage<T> {
  private readonly inputsNow: () => readonly unknown[];
  private readonly compute: () => T;
  private inputs: readonly unknown[] = [];
  private number = 0;
  private computed: { readonly value: T; readonly revision: number } | null = null;

  /** @param inputsNow what the value is a function of, each compared by identity */
  constructor(inputsNow: () => readonly unknown[], compute: () => T) {
    this.inputsNow = inputsNow;
    this.compute = compute;
  }

  /** Changes with the inputs; to ask computes nothing. */
  get revision(): number {
    const inputs = this.inputsNow();
    if (this.number === 0 || !inputs.every((input, i) => input === this.inputs[i])) {
      this.inputs = inputs;
      this.number = ++latest;
    }
    return this.number;
  }

  get value(): T {
    const { revision } = this;
    if (this.computed?.revision !== revision) this.computed = { value: this.compute(), revision };
    return this.computed.value;
  }
}
