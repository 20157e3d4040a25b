import { type AspectId, aspects } from '../../document/shots.ts';
import type { Looking } from '../editor.ts';
import { setAspect, shownShot } from '../shots.ts';

/** The form of the shot that is shown. */
export function AspectChoice({ editor }: { readonly editor: Looking }) {
  return (
    <select
      aria-label="Aspect of the shot"
      value={shownShot(editor)?.aspect}
      onChange={(event) => setAspect(editor, event.currentTarget.value as AspectId)}
    >
      {aspects.map(({ id, label }) => (
        <option key={id} value={id}>
          {label}
        </option>
      ))}
    </select>
  );
}
