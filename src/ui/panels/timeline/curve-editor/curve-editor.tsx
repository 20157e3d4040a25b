import '../../../styles/curve-editor.css';
import { useEffect } from 'preact/hooks';
import { printable } from '../../../../core/diagnostics.ts';
import { curveModel } from '../../../curve-editor/curve-model.ts';
import { selectedJoints } from '../../../../document/selected-joints.ts';
import type { TimelineViewProperties } from '../../../timeline/views.ts';
import { AskedKey } from './asked-key.tsx';
import { ChannelList } from './channel-list.tsx';
import { KeyFields } from './key-fields.tsx';
import { KeyTable } from './key-table.tsx';
import { Plot } from './plot.tsx';
import { TangentBar } from './tangent-bar.tsx';

/** The curves of the selected joints, by which their keys and slopes are edited. */
export function CurveEditor({ editor, actor, index }: TimelineViewProperties) {
  const model = curveModel(editor);
  const joints = selectedJoints(editor.session);
  const names = joints.map((joint) => actor.character.skeleton.names[joint] ?? '');
  const subject = names.length === 0 ? actor.name : names.join(', ');
  // Other curves have other ranges.
  useEffect(() => {
    model.values.value = null;
    model.fieldsAt.value = null;
    model.asked.value = null;
  }, [model, actor.id, index, names.join(), model.showsAll.value, model.isNormalized.value]);
  const isEmpty = model.curves.value.length === 0;
  return (
    <div class="curve-editor">
      <ChannelList model={model} />
      <div class="plot-area">
        <Plot editor={editor} model={model} label={`Curves of ${printable(subject, 80)}`} />
        {isEmpty && (
          <p class="hint empty">
            The clip does not move {printable(subject, 80)}. “All” shows every curve of the clip.
          </p>
        )}
        <KeyFields editor={editor} model={model} />
        {model.showsTable.value && <KeyTable editor={editor} model={model} />}
        <AskedKey editor={editor} model={model} />
      </div>
      <TangentBar editor={editor} model={model} />
    </div>
  );
}
