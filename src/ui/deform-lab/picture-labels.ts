import { printable } from '../../core/diagnostics.ts';
import type { Camera } from '../../document/camera.ts';
import type { DrawOver } from '../../view/picture/draw-over.ts';
import type { CaptureSize } from '../../view/viewer.ts';
import type { Looking } from '../editor.ts';
import { formatSize } from '../number-text.ts';
import { comparedOf } from './compared.ts';
import { differenceText, percentText } from './difference-text.ts';
import { drawDivider, drawLegend, drawMark, drawName } from './draw-labels.ts';
import { heatScale } from './heat-scale.ts';
import { methodPlaces } from './method-places.ts';
import { placeOfWorst, viewPlace } from './place-of-worst.ts';

/** A picture of this height, or a view of this width in it, has text in units of one pixel. */
const [plainHeight, plainWidth] = [480, 300];

/**
 * Returns what draws over a picture of the comparison that is shown now: the names of the methods, the
 * lines between them, the largest difference with its figure, and what the colors of a heat map mean.
 * It is null while nothing is compared.
 *
 * @param camera that of the picture, in each of its views; null in a movie, where the largest
 *   difference is at another place from frame to frame and is not marked
 */
export function pictureLabels(
  editor: Looking,
  camera: Camera | null,
  size: CaptureSize,
): DrawOver | null {
  const comparison = editor.session.comparison.peek();
  const compared = comparedOf(editor);
  if (!comparison || !compared) return null;
  const { width, height } = size;
  const columns = comparison.layout === 'wipe' ? 1 : comparison.methods.length;
  const unit = Math.max(1, Math.min(height / plainHeight, width / columns / plainWidth));
  const places = methodPlaces(comparison);
  const names = compared.rows.map(({ kernel }) => kernel.label);
  const worst = placeOfWorst(compared);
  const worstColumn = compared.rows.findIndex(({ method }) => method === compared.worst?.method);
  const aspect = width / columns / height;
  const mark = worst &&
    camera && {
      text: differenceText(compared.worst!.difference.largest, compared.size),
      from: viewPlace(camera, aspect, worst.base),
      to: viewPlace(camera, aspect, worst.other),
    };
  const scale = comparison.heatMap && worst ? heatScale(compared) : 0;
  const ticks = [0, 0.5, 1].map((part) => {
    const value = part * scale;
    return `${formatSize(value)} (${percentText(value, compared.size)})`;
  });
  const { name } = compared.base.evaluation.state;
  const about = `Difference from ${compared.base.kernel.label} in units of ${printable(name, 40)}, and of its height`;

  return (context) => {
    for (const [from] of places.slice(1)) drawDivider(context, from * width, unit);
    for (let column = 0; mark && column < columns; column++) {
      const hasText = columns === 1 || column === worstColumn;
      drawMark(context, { ...mark, text: hasText ? mark.text : null }, column, columns, unit);
    }
    places.forEach(([from, to], i) => {
      drawName(context, names[i]!, [from * width, to * width], unit);
    });
    if (scale > 0) drawLegend(context, about, ticks, unit);
  };
}
