import { useEffect, useRef } from 'preact/hooks';
import { showWorstAgain } from '../../deform-lab/open-comparison.ts';
import type { Looking, Telling } from '../../editor.ts';

/**
 * Says how far the methods differ when another character is selected during a comparison, or its rows
 * are changed. Whoever opens a comparison says it there.
 */
export function useTelling(editor: Looking & Telling): void {
  const { comparison, selectedActorId } = editor.session;
  const { value } = comparison;
  const subject = value && `${selectedActorId.value} ${value.normalizeRows}`;
  const told = useRef(subject);
  useEffect(() => {
    const before = told.current;
    told.current = subject;
    if (before !== null && subject !== null && subject !== before) showWorstAgain(editor);
  }, [editor, subject]);
}
