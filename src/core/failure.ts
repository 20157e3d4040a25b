/**
 * Something outside of Sinew failed: the message is for the user. Whatever else is thrown is a fault of
 * Sinew itself.
 */
export class Failure extends Error {}

/**
 * A part of the program that is loaded at need. One that can't be had is a failure: after a new version
 * was put on the server, a page that is still open asks for parts that are gone.
 */
export async function loadPart<Part>(part: Promise<Part>): Promise<Part> {
  try {
    return await part;
  } catch (cause) {
    throw new Failure('A part of Sinew could not be loaded; reload the page', { cause });
  }
}
