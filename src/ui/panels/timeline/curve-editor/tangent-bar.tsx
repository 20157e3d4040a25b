import type { CommandId } from '../../../commands/registry.ts';
import type { CurveModel } from '../../../curve-editor/curve-model.ts';
import { exactText, parseAmount } from '../../../curve-editor/key-text.ts';
import { typedKeysOf } from '../../../curve-editor/typed-keys.ts';
import type { Editor } from '../../../editor.ts';
import { CommandButton } from '../../command-button.tsx';
import { TypedField } from './typed-field.tsx';
import { setTcb } from '../../../curve-editor/tangent-edits.ts';
import type { Tcb } from '../../../../core/motion/clip-parts.ts';

interface TangentBarProperties {
  readonly editor: Editor;
  readonly model: CurveModel;
}

const kinds: readonly CommandId[] = [
  'tangents-auto',
  'tangents-smooth',
  'tangents-linear',
  'tangents-flat',
  'tangents-fixed',
  'tangents-stepped',
  'tangents-tcb',
];

/** The tangents of the selected keys, and how the plot is looked at. */
export function TangentBar({ editor, model }: TangentBarProperties) {
  return (
    <div class="tangent-bar" role="toolbar" aria-label="Curves">
      <select
        aria-label="Side of the keys"
        value={model.side.value}
        onChange={({ currentTarget }) => {
          model.side.value = currentTarget.value as 'in' | 'out' | 'both';
        }}
      >
        <option value="both">In, out</option>
        <option value="in">In</option>
        <option value="out">Out</option>
      </select>
      {kinds.map((command) => (
        <CommandButton key={command} editor={editor} command={command} />
      ))}
      <TcbFields editor={editor} model={model} />
      <CommandButton editor={editor} command="unify-handles" />
      <Switch label="Break" title="Handles turn each side alone" flag={model.breaksHandles} />
      <span class="gap" />
      <CommandButton editor={editor} command="insert-curve-key" />
      <CommandButton editor={editor} command="frame-keys" sign="⤢" />
      <Switch label="All" title="Curves of all joints" flag={model.showsAll} />
      <Switch label="Fit each" title="Each curve in its own range" flag={model.isNormalized} />
      <Switch label="Table" title="Keys of the chosen curve as a table" flag={model.showsTable} />
    </div>
  );
}

interface SwitchProperties {
  readonly label: string;
  readonly title: string;
  readonly flag: { value: boolean };
}

function Switch({ label, title, flag }: SwitchProperties) {
  return (
    <button
      type="button"
      title={title}
      aria-pressed={flag.value}
      onClick={() => (flag.value = !flag.value)}
    >
      {label}
    </button>
  );
}

const tcbNames = ['Tension', 'Continuity', 'Bias'] as const;

/** The three numbers of tangents by tension, continuity and bias. */
function TcbFields({ editor, model }: TangentBarProperties) {
  const keys = typedKeysOf(editor);
  const tangent = keys?.tangents[model.side.value === 'in' ? 'in' : 'out'];
  if (typeof tangent !== 'object' || tangent === null) return null;
  return (
    <span class="tcb">
      {tcbNames.map((name, at) => (
        <TypedField
          key={name}
          label={name}
          value={exactText(tangent.tcb[at]!)}
          onType={(text) => {
            const amount = parseAmount(text, 'number');
            if (amount !== null) setTcb(editor, tangent.tcb.with(at, amount) as unknown as Tcb);
            return amount !== null;
          }}
        />
      ))}
    </span>
  );
}
