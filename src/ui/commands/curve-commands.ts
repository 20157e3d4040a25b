import { loadPart } from '../../core/failure.ts';
import type { TangentKind } from '../curve-editor/tangent-edits.ts';
import type { Editor } from '../editor.ts';
import type { Command } from './command.ts';

const hasKeys = ({ session }: Editor): boolean => session.selectedKeys.value.size > 0;
const showsCurves = ({ session, transport }: Editor): boolean =>
  session.timelineView.value === 'curves' && transport.clip !== undefined;

/** The tangents of the selected keys, and what the curve editor does. */
export const curveCommands = [
  {
    id: 'show-curves',
    label: 'Curves of the clip in the timeline',
    isOn: ({ session }) => session.timelineView.value === 'curves',
    run: ({ session, tab }) => {
      tab.value = 'animate';
      session.timelineView.value = session.timelineView.value === 'curves' ? 'keys' : 'curves';
    },
  },
  tangents('auto', '1', 'automatic, without overshoot'),
  tangents('smooth', '2', 'smooth'),
  tangents('linear', '3', 'linear'),
  tangents('flat', '4', 'flat'),
  tangents('fixed', '5', 'fixed at the slopes that they have'),
  tangents('stepped', '6', 'stepped'),
  tangents('tcb', '7', 'those of tension, continuity and bias'),
  {
    id: 'unify-handles',
    label: 'Unify the handles of the selected keys: one slope on both sides',
    short: 'Unify',
    keys: [{ key: 'u' }],
    context: 'timeline',
    isEnabled: hasKeys,
    run: async (editor) => (await loadTangents()).unifyTangents(editor),
  },
  {
    id: 'insert-curve-key',
    label: 'Insert a key on the chosen curve at the playhead, without changing the curve',
    short: '+ Key',
    keys: [{ key: 'Insert' }],
    context: 'timeline',
    isEnabled: showsCurves,
    run: async (editor) =>
      (await loadPart(import('../curve-editor/insert-on-curve.ts'))).insertAtPlayhead(editor),
  },
] as const satisfies readonly Command[];

function tangents<Kind extends TangentKind>(kind: Kind, key: string, told: string) {
  return {
    id: `tangents-${kind}`,
    label: `Make the tangents of the selected keys ${told}`,
    short: kind === 'tcb' ? 'TCB' : `${kind[0]!.toUpperCase()}${kind.slice(1)}`,
    keys: [{ key }],
    context: 'timeline',
    isEnabled: hasKeys,
    run: async (editor: Editor) => (await loadTangents()).setTangentKind(editor, kind),
  } as const;
}

function loadTangents() {
  return loadPart(import('../curve-editor/tangent-edits.ts'));
}
