import type { Signal } from '@preact/signals-core';
import { Failure } from '../core/failure.ts';

/**
 * The message for the user about a thrown error. A fault of Sinew is also logged to the console.
 */
export function failureText(error: unknown): string {
  if (error instanceof Failure) return error.message;
  reportError(error);
  return 'Sinew itself failed at this; the page is as it was';
}

/**
 * Starts an action of the user without awaiting it; if it fails, the status line shows the message.
 */
export function attempt(
  { notice }: { readonly notice: Signal<string> },
  work: Promise<unknown>,
): void {
  work.catch((error: unknown) => {
    notice.value = failureText(error);
  });
}
