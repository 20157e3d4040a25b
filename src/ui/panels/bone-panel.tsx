import { useState } from 'preact/hooks';
import { posedRotation } from '../../core/bone-frames.ts';
import { bonesAt, framesOf, weighedCount } from '../bone-facts.ts';
import type { Looking } from '../editor.ts';
import { hoveredOf } from '../hovered-limb.ts';
import { fixedText } from '../number-text.ts';

/**
 * Shows the bone of the selected joint, or else of the highlighted one, as defined by the Virtual
 * Mannequin. A selection opens the panel, unless the user has opened or closed it.
 */
export function BonePanel({ editor }: { readonly editor: Looking }) {
  const [chosenOpen, setChosenOpen] = useState<boolean | null>(null);
  const { session } = editor;
  const selected = session.selectedJoint.value;
  const open = chosenOpen ?? selected !== null;
  // While the panel is closed, it subscribes to nothing.
  const joint = open ? (selected ?? hoveredOf(session)?.joint ?? null) : null;
  return (
    <details class="section bone" open={open}>
      <summary
        onClick={(event) => {
          event.preventDefault();
          setChosenOpen(!open);
        }}
      >
        Bone
      </summary>
      {open && joint === null && <p class="hint">Point at a joint, or select one.</p>}
      {joint !== null && <BonesOfJoint key={joint} editor={editor} joint={joint} />}
    </details>
  );
}

interface BoneProperties {
  readonly editor: Looking;
  readonly joint: number;
}

function BonesOfJoint({ editor, joint }: BoneProperties) {
  const [choice, setChoice] = useState(0);
  const shown = editor.evaluations.selected();
  if (!shown) return null;
  const { character } = shown.state;
  const { skeleton } = character;
  const frames = framesOf(skeleton);
  const bones = bonesAt(frames, joint);
  const bone = bones[choice] ?? bones[0];
  const frame = bone === undefined ? undefined : frames[bone];
  if (bone === undefined || !frame) return <p class="hint">No bone starts or ends here.</p>;
  const nameOf = (each: number): string => skeleton.names[each]!;
  const { source, destination, parent, length, translation, rotation, axes } = frame;
  const isFirst = parent === -1;
  return (
    <>
      <dl>
        <dt>from</dt>
        <dd>{nameOf(source)}</dd>
        <dt>to</dt>
        <dd>
          {bones.length === 1 ? (
            nameOf(destination)
          ) : (
            <select
              aria-label="Bone to"
              value={choice}
              onChange={({ currentTarget }) => setChoice(Number(currentTarget.value))}
            >
              {bones.map((each, index) => (
                <option key={each} value={index}>
                  {nameOf(frames[each]!.destination)}
                </option>
              ))}
            </select>
          )}
        </dd>
        <dt>L</dt>
        <dd>{fixedText(length)}</dd>
        <dt>vertices</dt>
        <dd>{weighedCount(character, bone).toLocaleString('en')}</dd>
      </dl>
      <Matrix
        caption={isFirst ? 'T, in the world' : 'T, along the parent’s t'}
        rows={[[12, 13, 14]]}
        of={translation}
      />
      <Matrix
        caption={isFirst ? 'R, to the world’s axes' : 'R, to the parent’s axes'}
        rows={rotationRows}
        of={rotation}
      />
      <Matrix
        caption="S, R as posed"
        rows={rotationRows}
        of={posedRotation(frames, bone, shown.characterFromJoint)}
      />
      <Matrix caption="Axes at rest, world" heads={['t', 'n', 'b']} rows={rotationRows} of={axes} />
    </>
  );
}

/** The rotation part of a column-major 4 × 4 matrix. */
const rotationRows = [0, 1, 2].map((row) => [row, row + 4, row + 8]);

interface MatrixProperties {
  readonly caption: string;
  /** Headings of the columns. */
  readonly heads?: readonly string[];
  /** Indices of the elements in each row. */
  readonly rows: readonly (readonly number[])[];
  readonly of: ArrayLike<number>;
}

function Matrix({ caption, heads, rows, of }: MatrixProperties) {
  return (
    <table>
      <caption>{caption}</caption>
      {heads && (
        <thead>
          <tr>
            {heads.map((head) => (
              <th key={head} scope="col">
                {head}
              </th>
            ))}
          </tr>
        </thead>
      )}
      <tbody>
        {rows.map((elements, row) => (
          <tr key={row}>
            {elements.map((element) => (
              <td key={element}>{fixedText(of[element]!)}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
