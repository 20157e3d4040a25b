import type { Curve } from './group.ts';

const panel = { width: 300, height: 260, left: 48, right: 12, top: 28, bottom: 40 };
const colors = ['#2f6fb7', '#d9480f'];
/** Works on light and on dark pages. */
const ink = '#7a7f87';

/** Draws curves over their counts, both in logarithms, with a panel for each kind of count. */
export function plotOf(curves: readonly Curve[]): string {
  const axes = [...new Set(curves.map(({ axis }) => axis))];
  const milliseconds = curves.flatMap(({ points }) => points.map(([, time]) => time));
  const y = decades(milliseconds);
  const width = axes.length * panel.width;
  const height = panel.height + 24;
  const panels = axes.map((axis, index) => {
    const own = curves.filter((curve) => curve.axis === axis);
    return `<g transform="translate(${index * panel.width} 0)">${panelOf(axis, own, y)}</g>`;
  });
  const names = [...new Set(curves.map(({ what }) => what))];
  const legend = names.map((name, i) => {
    const at = panel.left + i * 260;
    const line = `<path d="M${at} ${panel.height + 8}h24" stroke="${colors[i]!}" stroke-width="2"/>`;
    return line + text(at + 32, panel.height + 12, name);
  });
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" font-family="sans-serif" font-size="12" fill="none" role="img">`,
    `<title>Milliseconds for a pose against ${axes.join(', ')}</title>`,
    ...panels,
    ...legend,
    '</svg>\n',
  ].join('\n');
}

/** The powers of ten around all values. */
type Decades = readonly [lowest: number, highest: number];

function decades(values: readonly number[]): Decades {
  const low = Math.floor(Math.log10(Math.min(...values)));
  return [low, Math.max(low + 1, Math.ceil(Math.log10(Math.max(...values))))];
}

function panelOf(axis: string, curves: readonly Curve[], y: Decades): string {
  const x = decades(curves.flatMap(({ points }) => points.map(([count]) => count)));
  const right = panel.width - panel.right;
  const bottom = panel.height - panel.bottom;
  const atX = (count: number): number => scaled(Math.log10(count), x, [panel.left, right]);
  const atY = (time: number): number => scaled(Math.log10(time), y, [bottom, panel.top]);
  const parts: string[] = [text(panel.left, 16, `milliseconds against ${axis}`)];
  for (let power = x[0]; power <= x[1]; power++) {
    parts.push(grid(`M${round(atX(10 ** power))} ${panel.top}V${bottom}`));
    parts.push(text(atX(10 ** power), bottom + 16, countText(power), 'middle'));
  }
  for (let power = y[0]; power <= y[1]; power++) {
    parts.push(grid(`M${panel.left} ${round(atY(10 ** power))}H${right}`));
    parts.push(text(panel.left - 6, atY(10 ** power) + 4, String(10 ** power), 'end'));
  }
  curves.forEach(({ points }, i) => {
    const places = points.map(([count, time]) => `${round(atX(count))} ${round(atY(time))}`);
    parts.push(`<path d="M${places.join('L')}" stroke="${colors[i]!}" stroke-width="2"/>`);
    for (const place of places) {
      const [cx, cy] = place.split(' ');
      parts.push(`<circle cx="${cx!}" cy="${cy!}" r="3" fill="${colors[i]!}"/>`);
    }
  });
  return parts.join('\n');
}

function scaled(
  value: number,
  [low, high]: Decades,
  [from, to]: readonly [number, number],
): number {
  return from + ((value - low) / (high - low)) * (to - from);
}

function countText(power: number): string {
  return power >= 6
    ? `${10 ** (power - 6)}M`
    : power >= 3
      ? `${10 ** (power - 3)}k`
      : `${10 ** power}`;
}

function grid(path: string): string {
  return `<path d="${path}" stroke="${ink}" stroke-opacity="0.3"/>`;
}

function text(x: number, y: number, content: string, anchor = 'start'): string {
  return `<text x="${round(x)}" y="${round(y)}" fill="${ink}" text-anchor="${anchor}">${content}</text>`;
}

function round(value: number): number {
  return Math.round(value * 10) / 10;
}
