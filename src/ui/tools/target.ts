import { targetAt } from '../../view/ik-targets.ts';
import { showHoveredHandle } from '../hover.ts';
import type { Tool } from '../tool.ts';
import { dragLimb } from './ik.ts';

/** A left drag on a target of the file moves the end of its chain, with the chain's own length. */
export const targetTool: Tool = {
  id: 'target',
  poses: true,
  press(place, button, editor) {
    const target = button === 0 ? targetAt(editor, place) : null;
    if (!target) return null;
    const { joint, count, origin } = target;
    editor.session.chainLength.value = { joint, count };
    showHoveredHandle(editor, target.id);
    return dragLimb(editor, place, joint, origin);
  },
};
