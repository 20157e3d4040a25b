import type { GUI } from 'lil-gui';
import { type Light, setEnvironment, setLight, studioLights } from '../../document/environment.ts';
import type { Gesture } from '../../document/store.ts';
import type { Looking } from '../editor.ts';
import { watch } from '../watch.ts';
import { addValueRow } from './value-row.ts';

interface LightValue {
  readonly key: 'intensity' | 'azimuth' | 'elevation';
  readonly name: string;
  /** What a step of undo calls it. */
  readonly word: string;
  readonly minimum: number;
  readonly maximum: number;
}

const values: readonly LightValue[] = [
  { key: 'intensity', name: 'Strength', word: 'strength', minimum: 0, maximum: 3 },
  { key: 'azimuth', name: 'Around °', word: 'direction', minimum: -180, maximum: 180 },
  { key: 'elevation', name: 'Above °', word: 'height', minimum: -89, maximum: 89 },
];

/** Adds controls for the color, strength and direction of each light. */
export function addLightsFolder(gui: GUI, editor: Looking): void {
  const { store } = editor;
  const folder = gui.addFolder('Lights').close();
  const refreshers = store.scene.peek().environment.lights.flatMap(({ name }, index) => {
    const one = folder.addFolder(name).close();
    const rows = values.map((value) => addLightRow(one, editor, index, value));
    return [addColorRow(one, editor, index), ...rows];
  });
  const reset = (): void =>
    store.dispatch(setEnvironment({ lights: studioLights }, 'Reset the lights'));
  folder.add({ reset }, 'reset').name('Reset lights');
  watch([store.scene], () => {
    for (const refresh of refreshers) refresh();
  });
}

/** A drag over the colors is one step of undo. */
function addColorRow(folder: GUI, { store }: Looking, index: number): () => void {
  let gesture: Gesture | null = null;
  const lightNow = (): Light => store.scene.value.environment.lights[index]!;
  const labelNow = (): string => `${lightNow().name} light's color`;
  const bound = {
    get color(): string {
      return lightNow().color;
    },
    set color(color: string) {
      if (!gesture?.isOpen) gesture = store.begin(labelNow());
      gesture.preview(setLight(index, { color }, labelNow()));
    },
  };
  const row = folder.addColor(bound, 'color').name('Color');
  row.onFinishChange(() => {
    gesture?.commit();
    gesture = null;
  });
  return () => row.updateDisplay();
}

function addLightRow(
  folder: GUI,
  { store }: Looking,
  index: number,
  { key, name, word, minimum, maximum }: LightValue,
): () => void {
  const lightNow = (): Light => store.scene.value.environment.lights[index]!;
  const labelNow = (): string => `${lightNow().name} light's ${word}`;
  const write = (value: number) => setLight(index, { [key]: value }, labelNow());
  const row = addValueRow(folder, {
    name,
    fullName: `${lightNow().name} light ${name}`,
    minimum,
    maximum,
    legal: [minimum, maximum],
    isAngle: false,
    locked: false,
    read: () => lightNow()[key],
    begin: () => store.begin(labelNow()),
    preview: (gesture, value) => gesture.preview(write(value)),
    reset: () => store.dispatch(write(studioLights[index]![key])),
  });
  return () => row.refresh();
}
