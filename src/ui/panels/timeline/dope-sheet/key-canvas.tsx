import type { RefObject } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { drawRows, type KeyColors, type RowPicture } from '../../../timeline/draw-rows.ts';

interface KeyCanvasProperties {
  readonly picture: Omit<RowPicture, 'height' | 'scrollTop'>;
  /** The list of names, which the rows are scrolled with. */
  readonly names: RefObject<HTMLElement | null>;
}

/** Draws the rows of keys, at most once a frame, when anything that they show has changed. */
export function KeyCanvas({ picture, names }: KeyCanvasProperties) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const latest = useRef(picture);
  latest.current = picture;
  const frame = useRef(0);
  const request = (): void => {
    frame.current ||= requestAnimationFrame(() => {
      frame.current = 0;
      if (canvas.current) draw(canvas.current, latest.current, names.current?.scrollTop ?? 0);
    });
  };
  useEffect(request);
  useEffect(() => {
    const ending = new AbortController();
    const { signal } = ending;
    const list = names.current!;
    list.addEventListener('scroll', request, { signal });
    // Colors follow the system's theme, or the page's.
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', request, { signal });
    const observer = new ResizeObserver(request);
    observer.observe(canvas.current!);
    const theme = new MutationObserver(request);
    theme.observe(document.documentElement, { attributeFilter: ['data-theme'] });
    return () => {
      ending.abort();
      observer.disconnect();
      theme.disconnect();
      cancelAnimationFrame(frame.current);
    };
  }, [names]);
  return <canvas ref={canvas} aria-hidden="true" />;
}

function draw(
  canvas: HTMLCanvasElement,
  picture: KeyCanvasProperties['picture'],
  scrollTop: number,
) {
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  const ratio = window.devicePixelRatio;
  const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== across) canvas.width = across;
  if (canvas.height !== down) canvas.height = down;
  const context = canvas.getContext('2d')!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  drawRows(context, { ...picture, width, height, scrollTop }, colorsOf(canvas));
}

/** The style sheet registers these as colors, so that they are given as the canvas understands. */
function colorsOf(canvas: HTMLCanvasElement): KeyColors {
  const style = getComputedStyle(canvas);
  const color = (name: string): string => style.getPropertyValue(`--key-${name}`);
  return {
    key: color('plain'),
    edge: color('edge'),
    chosen: color('chosen'),
    hold: color('hold'),
    line: color('line'),
    row: color('row'),
  };
}
