/** A seam: a new command is one file and one line in commands.ts. */
export interface Command {
  readonly name: string;
  readonly usage: string;
  /** What it does, in a sentence. */
  readonly summary: string;
  /** The exit code. */
  run(words: readonly string[]): Promise<number>;
}
