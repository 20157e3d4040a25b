import type { Viewer } from '../view/viewer.ts';

/** The elements of the page: the view in the middle, with panels around it. */
export interface Layout {
  readonly root: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly left: HTMLElement;
  readonly right: HTMLElement;
  /** This covers the view and holds progress, messages and the buttons for the drawers. */
  readonly overlay: HTMLElement;
  readonly foot: HTMLElement;
  readonly dialogs: HTMLElement;
  /** Keeps the picture at the size of the view, in device pixels. */
  follow(viewer: Viewer, pixelRatio?: number): void;
}

/** A higher ratio is not visible and would cost too much time on the GPU. */
const largestPixelRatio = 2;

export function createLayout(root: HTMLElement): Layout {
  const left = append(root, 'aside', 'left');
  const view = append(root, 'main', 'view');
  const right = append(root, 'aside', 'right');
  const foot = append(root, 'div', 'foot');
  left.setAttribute('aria-label', 'Characters and joints');
  right.setAttribute('aria-label', 'Controls');
  const canvas = view.appendChild(document.createElement('canvas'));
  canvas.className = 'scene';
  canvas.tabIndex = 0;
  // The canvas handles keys of its own, which a screen reader must pass on to it.
  canvas.setAttribute('role', 'application');
  canvas.setAttribute('aria-label', '3D view');
  const overlay = append(view, 'div', 'overlay');
  return {
    root,
    canvas,
    left,
    right,
    overlay,
    foot,
    dialogs: append(root, 'div', 'dialogs'),
    follow(viewer, pixelRatio) {
      const fit = (): void => {
        const ratio = pixelRatio ?? Math.min(devicePixelRatio, largestPixelRatio);
        const { width, height } = view.getBoundingClientRect();
        viewer.resize(
          Math.max(1, Math.round(width * ratio)),
          Math.max(1, Math.round(height * ratio)),
        );
      };
      new ResizeObserver(fit).observe(view);
      fit();
    },
  };
}

function append(parent: HTMLElement, tag: string, className: string): HTMLElement {
  const element = document.createElement(tag);
  element.className = className;
  return parent.appendChild(element);
}
