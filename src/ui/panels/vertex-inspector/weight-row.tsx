import { sumOf } from '../../../core/skin.ts';
import type { Editor } from '../../editor.ts';
import { type EditedVertex, entryName, setRow } from '../../vertex-inspector/vertex-weights.ts';
import { CommandButton } from '../command-button.tsx';
import { EntrySwatch } from './entry-swatch.tsx';
import { WeightField } from './weight-field.tsx';

interface WeightRowProperties {
  readonly editor: Editor;
  readonly vertex: EditedVertex;
}

/** The weights of the vertex, which can be changed; joints can be added and removed. */
export function WeightRow({ editor, vertex }: WeightRowProperties) {
  const { actor, point, row } = vertex;
  const sum = sumOf(row);
  const isUneven = Math.abs(sum - 1) > 1e-3;
  return (
    <fieldset class="weights">
      <legend>Weights</legend>
      <ul>
        {row.map(({ entry }, index) => {
          const name = entryName(actor, entry);
          return (
            <li key={entry}>
              <EntrySwatch actor={actor} entry={entry} />
              <span class="name" title={name}>
                {name}
              </span>
              <WeightField editor={editor} vertex={vertex} index={index} name={name} />
              <button
                type="button"
                aria-label={`Remove ${name}`}
                title={`Remove ${name}`}
                disabled={row.length === 1}
                onClick={() => {
                  const others = row.filter((_, i) => i !== index);
                  setRow(editor, vertex, others, `Remove ${name} from vertex ${point}`);
                }}
              >
                ×
              </button>
            </li>
          );
        })}
      </ul>
      <p class="sum">
        <output class={isUneven ? 'uneven' : ''}>
          Σ {sum.toFixed(4)}
          {isUneven && ', so the vertex is drawn to the origin or away from it'}
        </output>
      </p>
      <AddJoint editor={editor} vertex={vertex} />
      <div class="lab-buttons">
        <CommandButton editor={editor} command="normalize-vertex" />
        <CommandButton editor={editor} command="reset-vertex" />
      </div>
      {(actor.normalizeWeights || actor.influences !== null) && (
        <p class="hint">
          {actor.influences !== null && `Only the ${actor.influences} strongest are used. `}
          {actor.normalizeWeights && 'They are divided by their sum where they are used.'}
        </p>
      )}
    </fieldset>
  );
}

/** Adds a joint with weight 0, so that nothing moves until its weight is changed. */
function AddJoint({ editor, vertex }: WeightRowProperties) {
  const { actor, point, row } = vertex;
  const entries = [...actor.character.skin.paletteJoint.keys()];
  const others = entries.filter((entry) => !row.some((each) => each.entry === entry));
  if (others.length === 0) return null;
  return (
    <select
      aria-label="Add a joint to the vertex"
      value=""
      onChange={({ currentTarget }) => {
        const entry = Number(currentTarget.value);
        currentTarget.value = '';
        const name = entryName(actor, entry);
        setRow(editor, vertex, [...row, { entry, weight: 0 }], `Add ${name} to vertex ${point}`);
      }}
    >
      <option value="">Add a joint…</option>
      {others.map((entry) => (
        <option key={entry} value={entry}>
          {entryName(actor, entry)}
        </option>
      ))}
    </select>
  );
}
