/** A command of the command line. To add one, write a file and add a line to commands.ts. */
export interface Command {
  readonly name: string;
  /** What follows `sinew`; another way to use it is on a line of its own. */
  readonly usage: string;
  /** One sentence that says what the command does. */
  readonly summary: string;
  /** Runs the command with the words after its name and returns the exit code. */
  run(words: readonly string[]): Promise<number>;
}
