import type { GUI } from 'lil-gui';
import { setEnvironment } from '../../document/environment-edits.ts';
import type {
  BackgroundKind,
  Environment,
  FloorKind,
  ShadowKind,
} from '../../document/environment.ts';
import { lightPresets, presetOf } from '../../document/light-presets.ts';
import type { Editor } from '../editor.ts';
import { watch } from '../watch.ts';
import { addCommandRow } from './command-row.ts';
import {
  addChoiceRow,
  addColorRow,
  addNumberRow,
  type EnvironmentNumber,
  type EnvironmentRow,
  type EnvironmentValue,
} from './environment-rows.ts';
import { addLightFolders } from './light-folders.ts';

/** What the menu of presets shows if the environment is none of them. */
const own = 'own';

const preset: EnvironmentValue<string> = {
  name: 'Preset',
  fullName: 'Preset of light and floor',
  read: (environment) => presetOf(environment)?.id ?? own,
  write(id, now) {
    const chosen = lightPresets.find((each) => each.id === id);
    return setEnvironment(chosen?.environment ?? now, `Light: ${chosen?.label ?? 'as it is'}`);
  },
};
const presets = {
  ...Object.fromEntries(lightPresets.map(({ label, id }) => [label, id])),
  'My own': own,
};

const shadow: EnvironmentValue<ShadowKind> = {
  name: 'Shadow',
  fullName: 'Shadow of the key light',
  read: (environment) => environment.shadow.kind,
  write: (kind, now) => setEnvironment({ shadow: { ...now.shadow, kind } }, 'Shadow'),
};
const shadows: Record<string, ShadowKind> = {
  Soft: 'mapped',
  'Sharp, floor alone': 'planar',
  Off: 'off',
};

const darkness: EnvironmentNumber = {
  name: 'Darkness',
  fullName: 'Darkness of the shadow',
  ...{ minimum: 0, maximum: 1 },
  read: (environment) => environment.shadow.darkness,
  write: (value, now) =>
    setEnvironment({ shadow: { ...now.shadow, darkness: value } }, 'Darkness of the shadow'),
};

const floor: EnvironmentValue<FloorKind> = {
  name: 'Floor',
  fullName: 'Floor',
  read: (environment) => environment.floor.kind,
  write: (kind, now) => setEnvironment({ floor: { ...now.floor, kind } }, 'Floor'),
};
const floors: Record<string, FloorKind> = { Checks: 'checks', Plain: 'plain', Off: 'off' };

const reflection: EnvironmentNumber = {
  name: 'Reflection',
  fullName: 'Reflection in the floor',
  ...{ minimum: 0, maximum: 1 },
  read: (environment) => environment.floor.reflection,
  write: (value, now) =>
    setEnvironment({ floor: { ...now.floor, reflection: value } }, 'Reflection in the floor'),
};

const background: EnvironmentValue<BackgroundKind> = {
  name: 'Background',
  fullName: 'Background',
  read: (environment) => environment.background.kind,
  write: (kind, now) => setEnvironment({ background: { ...now.background, kind } }, 'Background'),
};
const backgrounds: Record<string, BackgroundKind> = {
  'As the page': 'theme',
  Color: 'color',
  Gradient: 'gradient',
  Transparent: 'transparent',
};

/** Returns a color of the background. */
function backgroundColor(key: 'color' | 'topColor', name: string): EnvironmentValue<string> {
  return {
    name,
    fullName: `Background ${name}`,
    read: (environment) => environment.background[key],
    write: (value, now) =>
      setEnvironment({ background: { ...now.background, [key]: value } }, 'Background color'),
  };
}

/** Adds controls for what surrounds the actors: light, shadow, floor and background. */
export function addEnvironmentFolder(gui: GUI, editor: Editor): void {
  const { store } = editor;
  const folder = gui.addFolder('Light and floor').close();
  const presetRow = addChoiceRow(folder, editor, preset, presets);
  addCommandRow(folder, editor, 'drag-lights');
  const shadowRow = addChoiceRow(folder, editor, shadow, shadows);
  const darknessRow = addNumberRow(folder, editor, darkness);
  const floorRow = addChoiceRow(folder, editor, floor, floors);
  const reflectionRow = addNumberRow(folder, editor, reflection);
  const backgroundRow = addChoiceRow(folder, editor, background, backgrounds);
  const colorRow = addColorRow(folder, editor, backgroundColor('color', 'Color'));
  const topRow = addColorRow(folder, editor, backgroundColor('topColor', 'Upper color'));
  const rows: readonly EnvironmentRow[] = [
    ...[presetRow, shadowRow, darknessRow, floorRow, reflectionRow],
    ...[backgroundRow, colorRow, topRow],
    ...addLightFolders(folder, editor),
  ];
  watch([store.scene], () => {
    const { environment } = store.scene.value;
    showWhatCounts(environment);
    for (const row of rows) row.refresh();
  });

  /** A number that would change nothing is out of sight. */
  function showWhatCounts({ floor, shadow, background }: Environment): void {
    const hasFloor = floor.kind !== 'off';
    darknessRow.show(hasFloor && shadow.kind !== 'off');
    reflectionRow.show(hasFloor);
    colorRow.show(background.kind === 'color' || background.kind === 'gradient');
    topRow.show(background.kind === 'gradient');
  }
}
