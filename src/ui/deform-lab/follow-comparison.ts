import { effect } from '@preact/signals-core';
import type { Comparison } from '../../document/comparison.ts';
import { type ActorId, actorById } from '../../document/scene.ts';
import type { MethodId } from '../../skinning/method.ts';
import { overridesOf } from '../../evaluation/comparison/overrides.ts';
import { heatPaint } from '../../view/heat-map.ts';
import type { ViewContent } from '../../view/render-view.ts';
import type { Looking } from '../editor.ts';
import { comparedOf } from './compared.ts';
import { heatScale } from './heat-scale.ts';

type Part = Omit<ViewContent, 'camera'>;

const whole: readonly Part[] = [{ overrides: {} }];

/** Keeps the view divided as the session compares methods. */
export function followComparison(editor: Looking): void {
  const { session, viewer } = editor;
  effect(() => {
    const comparison = session.comparison.value;
    viewer.parts.value = comparison ? partsOf(editor, comparison) : whole;
  });
}

function partsOf(editor: Looking, comparison: Comparison): readonly Part[] {
  const { methods, layout, wipes, base, heatMap } = comparison;
  const { unlitWeights } = editor.session;
  const compared = heatMap ? comparedOf(editor) : null;
  const scale = heatScale(compared);
  const { kernels } = editor.evaluations.pool;
  const { deformation } = overridesOf(methods[base]!, comparison);
  const baseOf = (id: ActorId): MethodId =>
    deformation?.method ?? actorById(editor.store.scene.peek(), id)?.method ?? 'linear-blend';
  const weights = {
    ...{ view: 'error' as const, unlit: unlitWeights.value, marked: null },
    ...(compared && {
      paint: heatPaint(baseOf, kernels, scale / compared.size.height),
    }),
  };
  return methods.map((method, index): Part => {
    return {
      overrides: overridesOf(method, comparison),
      ...(heatMap && index !== base && scale > 0 && { options: { weights } }),
      ...(layout === 'wipe' && { span: [wipes[index - 1] ?? 0, wipes[index] ?? 1] }),
    };
  });
}
