import type { Signal } from '@preact/signals-core';
import { Failure } from '../core/failure.ts';

/** What a user is told of something that was thrown; a fault of Sinew goes to the console as well. */
export function failureText(error: unknown): string {
  if (error instanceof Failure) return error.message;
  reportError(error);
  return 'Sinew itself failed at this; the page is as it was';
}

/** Lets go of what a user started: where it fails, the status line says so. */
export function attempt(
  { notice }: { readonly notice: Signal<string> },
  work: Promise<unknown>,
): void {
  work.catch((error: unknown) => {
    notice.value = failureText(error);
  });
}
