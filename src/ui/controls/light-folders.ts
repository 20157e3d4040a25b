import type { GUI } from 'lil-gui';
import { setEnvironment, setLight } from '../../document/environment-edits.ts';
import type { Looking } from '../editor.ts';
import {
  addColorRow,
  addNumberRow,
  type EnvironmentNumber,
  type EnvironmentRow,
} from './environment-rows.ts';

interface LightValue extends Pick<EnvironmentNumber, 'name' | 'minimum' | 'maximum'> {
  readonly key: 'intensity' | 'azimuth' | 'elevation';
  /** What a step of undo calls it. */
  readonly word: string;
}

const values: readonly LightValue[] = [
  { key: 'intensity', name: 'Strength', word: 'strength', minimum: 0, maximum: 3 },
  { key: 'azimuth', name: 'Around °', word: 'direction', minimum: -180, maximum: 180 },
  { key: 'elevation', name: 'Above °', word: 'height', minimum: -89, maximum: 89 },
];

/** Adds a folder for each light, and one for the light from all around. */
export function addLightFolders(folder: GUI, editor: Looking): EnvironmentRow[] {
  const { lights } = editor.store.scene.peek().environment;
  const rows = lights.flatMap(({ name }, index) =>
    addLightFolder(folder.addFolder(name).close(), editor, index, `${name} light`),
  );
  return [...rows, ...addAmbientFolder(folder.addFolder('Ambient').close(), editor)];
}

function addLightFolder(
  folder: GUI,
  editor: Looking,
  index: number,
  title: string,
): EnvironmentRow[] {
  const color = addColorRow(folder, editor, {
    name: 'Color',
    fullName: `${title} Color`,
    read: ({ lights }) => lights[index]!.color,
    write: (color) => setLight(index, { color }, `${title}'s color`),
  });
  const numbers = values.map(({ key, word, ...shown }) =>
    addNumberRow(folder, editor, {
      ...shown,
      fullName: `${title} ${shown.name}`,
      read: ({ lights }) => lights[index]![key],
      write: (value) => setLight(index, { [key]: value }, `${title}'s ${word}`),
    }),
  );
  return [color, ...numbers];
}

function addAmbientFolder(folder: GUI, editor: Looking): EnvironmentRow[] {
  const color = addColorRow(folder, editor, {
    name: 'Color',
    fullName: 'Ambient light Color',
    read: ({ ambient }) => ambient.color,
    write: (color, { ambient }) =>
      setEnvironment({ ambient: { ...ambient, color } }, "Ambient light's color"),
  });
  const strength = addNumberRow(folder, editor, {
    name: 'Strength',
    fullName: 'Ambient light Strength',
    ...{ minimum: 0, maximum: 3 },
    read: ({ ambient }) => ambient.intensity,
    write: (intensity, { ambient }) =>
      setEnvironment({ ambient: { ...ambient, intensity } }, "Ambient light's strength"),
  });
  return [color, strength];
}
