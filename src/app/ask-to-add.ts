import type { Opening } from '../ui/editor.ts';

/**
 * Asks whether what came is added or replaces the selected character. Resolves to null if the user
 * decides for neither, or if the signal is aborted, since then something else is being opened.
 *
 * @param name of what came
 * @param replaced name of the selected character
 */
export function askToAdd(
  { question, dialog }: Pick<Opening, 'question' | 'dialog'>,
  name: string,
  replaced: string,
  signal: AbortSignal,
): Promise<boolean | null> {
  return new Promise((resolve) => {
    const answer = (add: boolean | null): void => {
      if (question.value !== asked) return;
      signal.removeEventListener('abort', giveUp);
      question.value = null;
      if (dialog.value === 'arrival') dialog.value = null;
      resolve(add);
    };
    const giveUp = (): void => answer(null);
    const asked = { name, replaced, answer };
    signal.addEventListener('abort', giveUp);
    question.value = asked;
    dialog.value = 'arrival';
  });
}
