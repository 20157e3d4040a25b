import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { printable } from '../../core/diagnostics.ts';
import type { Editor } from '../editor.ts';

/** Asks where opened characters go. Enter replaces, and closing the dialog opens nothing. */
export function Arrival({ editor }: { readonly editor: Editor }) {
  const question = editor.question.value;
  const first = useRef<HTMLButtonElement>(null);
  useLayoutEffect(() => first.current?.focus(), []);
  useEffect(() => () => question?.answer(null), [question]);
  if (!question) return null;
  const [name, replaced] = [printable(question.name, 60), printable(question.replaced, 60)];
  return (
    <>
      <p>
        {name} is read, and {replaced} is open.
      </p>
      <div class="buttons">
        <button ref={first} type="button" class="primary" onClick={() => question.answer(false)}>
          Replace {replaced}
        </button>
        <button type="button" onClick={() => question.answer(true)}>
          Add {name}
        </button>
      </div>
    </>
  );
}
