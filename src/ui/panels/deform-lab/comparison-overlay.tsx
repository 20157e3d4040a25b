import '../../styles/deform-lab.css';
import { comparedOf } from '../../deform-lab/compared.ts';
import { methodPlaces } from '../../deform-lab/method-places.ts';
import { remarkOn } from '../../deform-lab/method-remark.ts';
import { telling } from '../../deform-lab/open-comparison.ts';
import type { Editor } from '../../editor.ts';
import { CommandButton } from '../command-button.tsx';
import { HeatLegend } from './heat-legend.tsx';
import { OfferedPoses } from './offered-poses.tsx';
import { useTelling } from './use-telling.ts';
import { WipeHandle } from './wipe-handle.tsx';
import { WorstMark } from './worst-mark.tsx';

/**
 * Over the view while methods are compared: their names, the wipes between them, where they differ
 * most, and what the colors mean.
 */
export function ComparisonOverlay({ editor }: { readonly editor: Editor }) {
  const comparison = editor.session.comparison.value;
  const compared = comparedOf(editor);
  useTelling(editor);
  if (!comparison || !compared) return null;
  const { rows, base, worst, size } = compared;
  const isWipe = comparison.layout === 'wipe';
  const places = methodPlaces(comparison);
  const isReady = rows.every(({ evaluation }) => evaluation.pending.length === 0);
  const isAlike = isReady && (worst?.difference.largest ?? 0) < telling * size.height;
  return (
    <>
      <div class={`compared ${isWipe ? '' : 'apart'}`}>
        {rows.map(({ method, kernel, evaluation }, index) => {
          const [from, to] = places[index]!;
          const place = { left: `${from * 100}%`, width: `${(to - from) * 100}%` };
          return (
            <span key={method} style={place}>
              <span data-short={kernel.short} title={kernel.label}>
                {kernel.label}
                {remarkOn(kernel, evaluation)}
              </span>
            </span>
          );
        })}
      </div>
      <div class="change-comparison" role="group" aria-label="Compared methods">
        <CommandButton editor={editor} command="comparison-layout" icon="side-by-side" />
        <CommandButton editor={editor} command="compare-one-more" icon="plus" />
      </div>
      <WorstMark editor={editor} compared={compared} columns={isWipe ? 1 : rows.length} />
      {isWipe &&
        comparison.wipes.map((_, index) => (
          <WipeHandle key={index} editor={editor} index={index} />
        ))}
      <div class="comparison-foot">
        {isAlike && <OfferedPoses editor={editor} about />}
        {comparison.heatMap && worst && <HeatLegend compared={compared} base={base} />}
      </div>
    </>
  );
}
