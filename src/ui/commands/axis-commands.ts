import { alongAxis, type AxisViewId } from '../../view/axis-views.ts';
import type { Editor } from '../editor.ts';
import type { Command } from './command.ts';

/** Commands that look along an axis, with the keys of Blender's numeric keypad. */
export const axisCommands = [
  {
    id: 'orthographic',
    label: 'Orthographic view, without perspective',
    short: 'Orthographic',
    keys: [{ key: '5' }],
    isOn: ({ viewer }) => viewer.camera.value.projection === 'orthographic',
    run: toggleProjection,
  },
  {
    id: 'view-front',
    label: 'Front view',
    short: 'Front',
    keys: [{ key: '1' }],
    run: (editor) => lookAlong(editor, 'front'),
  },
  {
    id: 'view-back',
    label: 'Back view',
    short: 'Back',
    keys: [{ key: '1', control: true }],
    run: (editor) => lookAlong(editor, 'back'),
  },
  {
    id: 'view-right',
    label: 'Right view',
    short: 'Right',
    keys: [{ key: '3' }],
    run: (editor) => lookAlong(editor, 'right'),
  },
  {
    id: 'view-left',
    label: 'Left view',
    short: 'Left',
    keys: [{ key: '3', control: true }],
    run: (editor) => lookAlong(editor, 'left'),
  },
  {
    id: 'view-top',
    label: 'Top view',
    short: 'Top',
    keys: [{ key: '7' }],
    run: (editor) => lookAlong(editor, 'top'),
  },
  {
    id: 'view-bottom',
    label: 'Bottom view',
    short: 'Bottom',
    keys: [{ key: '7', control: true }],
    run: (editor) => lookAlong(editor, 'bottom'),
  },
] as const satisfies readonly Command[];

/** The first-person camera has perspective, so this leaves it. */
function lookAlong({ viewer: { camera }, session }: Editor, id: AxisViewId): void {
  session.firstPerson.value = false;
  camera.value = alongAxis(camera.value, id);
}

function toggleProjection({ viewer: { camera }, session }: Editor): void {
  const isFlat = camera.value.projection === 'orthographic';
  session.firstPerson.value = false;
  camera.value = { ...camera.value, projection: isFlat ? 'perspective' : 'orthographic' };
}
