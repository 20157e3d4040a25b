import { loadPart } from '../../core/failure.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { cuttingSettings } from '../deform-lab/cutting-settings.ts';
import type { FigureForm } from '../deform-lab/save-figure.ts';
import type { Editor } from '../editor.ts';
import { toggleLab } from '../toggle-lab.ts';
import type { Command } from './command.ts';

const hasFigure = ({ session }: Editor): boolean => cuttingSettings(session).figure.value !== null;

const save =
  (form: FigureForm): Command['run'] =>
  async (editor) => {
    const { saveFigure } = await loadPart(import('../deform-lab/save-figure.ts'));
    await saveFigure(editor, form);
  };

/** The commands of the figure that cuts a character by a plane. */
export const cuttingCommands = [
  {
    id: 'cutting-figure',
    label: 'Cutting figure: outlines of rigid parts, linear blend and another method in a plane',
    short: 'Cutting figure',
    isOn: ({ session }) => cuttingSettings(session).isOpen.value,
    isEnabled: ({ store, session }) =>
      (selectedActor(store, session)?.character.skeleton.jointCount ?? 0) > 0,
    run: (editor) =>
      toggleLab(editor, cuttingSettings(editor.session).isOpen, 'deform', 'cutting-figure'),
  },
  {
    id: 'save-figure-svg',
    label: 'Save the cutting figure as SVG',
    short: 'Save SVG',
    isEnabled: hasFigure,
    run: save('svg'),
  },
  {
    id: 'save-figure-png',
    label: 'Save the cutting figure as PNG',
    short: 'Save PNG',
    isEnabled: hasFigure,
    run: save('png'),
  },
] as const satisfies readonly Command[];
