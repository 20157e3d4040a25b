/** What the page's style decides of a drawing's parts. */
const properties = [
  ...['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-linejoin', 'opacity'],
  ...['font-family', 'font-size', 'font-weight', 'text-anchor'],
];

/** A drawing in a picture. */
interface Drawing {
  readonly element: SVGSVGElement;
  readonly width: number;
  readonly height: number;
}

const margin = 8;

/**
 * Returns drawings of the page one below another as an SVG file of its own, which looks as they do on
 * the page now.
 */
export function standaloneSvg(drawings: readonly Drawing[]): string {
  const width = Math.max(...drawings.map((drawing) => drawing.width)) + 2 * margin;
  let top = margin;
  const parts = drawings.map(({ element, height }) => {
    const part = `<g transform="translate(${margin} ${top})">${contentOf(element)}</g>`;
    top += height + margin;
    return part;
  });
  const background = getComputedStyle(document.documentElement).getPropertyValue('--surface');
  const box = `viewBox="0 0 ${width} ${top}" width="${width * 3}" height="${top * 3}"`;
  const back = `<rect width="${width}" height="${top}" fill="${plainColor(background)}"/>`;
  return `<svg xmlns="http://www.w3.org/2000/svg" ${box}>${back}${parts.join('')}</svg>\n`;
}

function contentOf(element: SVGSVGElement): string {
  const copy = element.cloneNode(true) as SVGSVGElement;
  const [shown, copied] = [element, copy].map((each) => [...each.querySelectorAll('*')]);
  copied!.forEach((part, i) => {
    const style = getComputedStyle(shown![i]!);
    for (const property of properties)
      part.setAttribute(property, style.getPropertyValue(property));
    part.removeAttribute('class');
  });
  const serializer = new XMLSerializer();
  return [...copy.childNodes].map((node) => serializer.serializeToString(node)).join('');
}

/** A color of the theme as other programs read it. */
function plainColor(color: string): string {
  const probe = document.createElement('i');
  probe.style.color = color;
  document.body.append(probe);
  const plain = getComputedStyle(probe).color;
  probe.remove();
  return plain;
}
