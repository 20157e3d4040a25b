import type { CutRole } from '../../document/cutting.ts';
import { printable } from '../../core/diagnostics.ts';
import { type Figure, figureSide, type FigureView, pathData, scaleBar } from './figure-paths.ts';

/**
 * How outlines look on paper, in the order in which they are drawn. They differ in color for any eye, in
 * lightness, and in their dashes; the colors are those of cutting-figure.css in light surroundings.
 */
const looks: Readonly<Record<CutRole, string>> = {
  rigid: 'stroke="#c2560f" stroke-width="2.5" stroke-dasharray="1.5 4"',
  blend: 'stroke="#2b8ac9" stroke-width="2"',
  third: 'stroke="#14503c" stroke-width="1.75" stroke-dasharray="8 3"',
};

const rowHeight = 20;

/** Writes a figure as an SVG file with a legend and a scale bar, on white. */
export function figureSvg(figure: Figure, view: FigureView): string {
  const shown = figure.outlines.filter(({ isPending }) => !isPending);
  const title = `${figure.characterName}, cut at ${figure.jointName}`;
  const top = 28;
  const legend = top + figureSide + 24;
  const [width, height] = [figureSide + 20, legend + (shown.length + 1) * rowHeight];
  const bar = scaleBar(view);
  const barRow = legend + shown.length * rowHeight;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" font-family="sans-serif" font-size="12">`,
    `<title>${escaped(title)}</title>`,
    `<rect width="${width}" height="${height}" fill="#ffffff"/>`,
    `<text x="10" y="18" font-weight="bold">${escaped(title)}</text>`,
    `<svg x="10" y="${top}" width="${figureSide}" height="${figureSide}" viewBox="0 0 ${figureSide} ${figureSide}">`,
    ...shown.map(
      ({ role, lines }) =>
        `<path d="${pathData(lines, view)}" fill="none" stroke-linejoin="round" stroke-linecap="round" ${looks[role]}/>`,
    ),
    '</svg>',
    `<rect x="10" y="${top}" width="${figureSide}" height="${figureSide}" fill="none" stroke="#8a93a0"/>`,
    ...shown.flatMap(({ role, label }, i) => {
      const y = legend + i * rowHeight;
      return [
        `<path d="M10 ${y - 4}h36" fill="none" stroke-linecap="round" ${looks[role]}/>`,
        `<text x="54" y="${y}">${escaped(label)}</text>`,
      ];
    }),
    `<path d="M10 ${barRow - 8}v8h${bar.pixels}v-8" fill="none" stroke="#000000"/>`,
    `<text x="${18 + bar.pixels}" y="${barRow}">${bar.text}</text>`,
    '</svg>',
    '',
  ].join('\n');
}

function escaped(text: string): string {
  return printable(text).replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
