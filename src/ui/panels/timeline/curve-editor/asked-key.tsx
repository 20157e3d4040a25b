import { formatDegrees } from '../../../angle-text.ts';
import type { CurveModel } from '../../../curve-editor/curve-model.ts';
import { secondsText } from '../../../curve-editor/drag-texts.ts';
import { insertAsked } from '../../../curve-editor/insert-on-curve.ts';
import type { Editor } from '../../../editor.ts';

interface AskedKeyProperties {
  readonly editor: Editor;
  readonly model: CurveModel;
}

/** Says how far a rotation turns elsewhere if a key is inserted, before it is. */
export function AskedKey({ editor, model }: AskedKeyProperties) {
  const asked = model.asked.value;
  if (!asked) return null;
  const cancel = (): void => void (model.asked.value = null);
  return (
    <div
      class="asked-key"
      role="alertdialog"
      aria-label="Insert a key"
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        event.stopPropagation();
        cancel();
      }}
    >
      <p>
        A key at {secondsText(asked.time)} turns the joint by as much as {formatDegrees(asked.turn)}{' '}
        at other times.
      </p>
      <button type="button" ref={(button) => button?.focus()} onClick={() => insertAsked(editor)}>
        Insert
      </button>
      <button type="button" onClick={cancel}>
        Cancel
      </button>
    </div>
  );
}
