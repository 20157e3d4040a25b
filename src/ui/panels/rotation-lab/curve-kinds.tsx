import type { Editor } from '../../editor.ts';
import { commandOf } from '../../commands/registry.ts';
import { runCommand } from '../../commands/command.ts';
import { curveLabels } from '../../rotation-lab/conversions.ts';
import type { RotationLab } from '../../rotation-lab/rotation-lab.ts';
import { differenceText } from '../../rotation-lab/store-as.ts';
import type { Subject } from '../../rotation-lab/subject.ts';

interface CurveKindsProperties {
  readonly editor: Editor;
  readonly lab: RotationLab;
  readonly subject: Subject;
}

/**
 * The three kinds of curves through the same keys: the legend of the paths in the view, how far each
 * is from the stored one, and the buttons that store it.
 */
export function CurveKinds({ editor, lab, subject }: CurveKindsProperties) {
  return (
    <section class="kinds" aria-label="Kinds of curves">
      <h3>Paths in the view</h3>
      <p class="hint">
        Where the end of {subject.boneName} goes over the clip, through the same keys. The joints
        above it move as the clip moves them; pins do not count.
      </p>
      <ul>
        {lab.conversions.value.map(({ curve, isStored, refusal, ...difference }) => (
          <li key={curve}>
            <span class={`swatch ${curve}`} aria-hidden="true" />
            <div>
              <strong>{curveLabels[curve]}</strong>{' '}
              {isStored ? 'is stored.' : refusal || `${differenceText(difference)}.`}
            </div>
            <button
              type="button"
              aria-pressed={isStored}
              aria-label={`Store as ${curveLabels[curve]}`}
              disabled={refusal !== ''}
              title={refusal || `Store as ${curveLabels[curve]}`}
              onClick={() => runCommand(commandOf(`store-as-${curve}`), editor)}
            >
              Store
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
