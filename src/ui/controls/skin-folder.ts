import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import { comparisonOf } from '../../document/comparison.ts';
import { setMethod, setNormalizeWeights, setNormals } from '../../document/edits.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Session, SkinDevice } from '../../document/session.ts';
import type { NormalsId } from '../../core/skin.ts';
import type { KernelId, MethodId } from '../../skinning/method.ts';
import {
  kernelById,
  type KernelRow,
  kernels,
  menuName,
  methods,
  normalWays,
} from '../../skinning/registry.ts';
import type { Editor } from '../editor.ts';
import { leaveComparison } from '../deform-lab/open-comparison.ts';
import { watch } from '../watch.ts';
import { addCommandRow } from './command-row.ts';
import { addMethodRows } from './method-rows.ts';

/** Adds controls for deformation and shading of the skin, and for verification. */
export function addSkinFolder(gui: GUI, editor: Editor): void {
  const { store, session } = editor;
  const selected = () => selectedActor(store, session);
  /** The method in use, if it can't be computed on the GPU. */
  const onCpuAlone = (): KernelRow | null => {
    const method = editor.evaluations.selected()?.method;
    return method?.finish ? kernelById(method.id) : null;
  };
  const folder = gui.addFolder('Skin');
  const bound = {
    get method(): MethodId {
      return selected()?.method ?? methods[0]!.id;
    },
    set method(method: MethodId) {
      const state = selected();
      if (state) store.dispatch(setMethod(state.id, method));
    },
    get normals(): NormalsId {
      return selected()?.normals ?? 'blended';
    },
    set normals(normals: NormalsId) {
      const state = selected();
      if (state) store.dispatch(setNormals(state.id, normals));
    },
    get normalize(): boolean {
      return selected()?.normalizeWeights ?? false;
    },
    set normalize(normalize: boolean) {
      const state = selected();
      if (state) store.dispatch(setNormalizeWeights(state.id, normalize));
    },
    get compared(): KernelId | 'none' {
      return session.comparison.value?.methods.find((method) => method !== 'own') ?? 'none';
    },
    set compared(kernel: KernelId | 'none') {
      if (kernel === 'none') leaveComparison(editor);
      else session.comparison.value = { ...comparisonOf(['own', kernel]), layout: 'side by side' };
    },
    get device(): SkinDevice {
      return onCpuAlone() ? 'cpu' : session.skinDevice.value;
    },
    set device(device: SkinDevice) {
      session.skinDevice.value = device;
    },
  };
  const kernelChoices = <Id extends KernelId>(rows: readonly KernelRow<Id>[]) =>
    Object.fromEntries(rows.map((row) => [menuName(row), row.id]));
  const choicesOf = <T>(rows: readonly { readonly label: string; readonly id: T }[]) =>
    Object.fromEntries(rows.map(({ label, id }) => [label, id]));
  const chosen = [
    folder.add(bound, 'method', kernelChoices(methods)).name('Method'),
    folder.add(bound, 'normals', choicesOf(normalWays)).name('Normals'),
    folder
      .add(bound, 'compared', { Nothing: 'none', ...kernelChoices(kernels) })
      .name('Compare with'),
  ];
  const device = folder.add(bound, 'device', { GPU: 'gpu', CPU: 'cpu' }).name('Computed on');
  const normalize = folder.add(bound, 'normalize').name('Normalize weights');
  const rows = [...chosen, device, normalize];
  addMethodRows(folder, rows[0]!.domElement, editor);
  addCommandRow(folder, editor, 'method-help');
  addCommandRow(folder, editor, 'verify');
  addCommandRow(folder, editor, 'check-machine');
  const result = document.createElement('output');
  result.className = 'verification';
  folder.$children.append(result);

  const { skinDevice, comparison } = session;
  watch([store.scene, session.selectedActorId, skinDevice, comparison], () => {
    for (const row of rows) row.updateDisplay();
  });
  effect(() => {
    const alone = onCpuAlone();
    device.enable(!alone).updateDisplay();
    const remark = alone ? [`${alone.label} is computed on the CPU alone`] : [];
    result.replaceChildren(...[...remark, ...verificationLines(session)].map(textLine));
  });
}

function verificationLines({ verification }: Session): string[] {
  const found = verification.value;
  if (!found) return [];
  const difference = found.identical
    ? found.isOnCpu
      ? 'The GPU draws what the CPU computed, bit for bit'
      : 'GPU = CPU, bit for bit'
    : `|GPU − CPU| ≤ ${found.position.toExponential(2)} at vertex ${found.vertex}` +
      ` (${found.relative.toExponential(1)} of its size)`;
  if (found.bindError === null) return [difference];
  return [difference, `|T · B⁻¹ − I| ≤ ${found.bindError.toExponential(1)} at rest`];
}

function textLine(text: string): HTMLElement {
  const line = document.createElement('p');
  line.textContent = text;
  return line;
}
