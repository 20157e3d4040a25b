/**
 * A failure outside Sinew; its message is for the user. Any other thrown error is a fault of Sinew
 * itself.
 */
export class Failure extends Error {}

/**
 * Loads a module of the program on demand. If it can't be loaded, that is a `Failure`: after a
 * deployment, a page that is still open requests modules that no longer exist.
 */
export async function loadPart<Part>(part: Promise<Part>): Promise<Part> {
  try {
    return await part;
  } catch (cause) {
    throw new Failure('A part of Sinew could not be loaded; reload the page', { cause });
  }
}
