import type { Viewer } from '../view/viewer.ts';

/** The elements of the page: the view in the middle, with bars and panels around it. */
export interface Layout {
  readonly root: HTMLElement;
  readonly top: HTMLElement;
  readonly view: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly left: HTMLElement;
  readonly right: HTMLElement;
  /** On a phone, the buttons that open the panels. */
  readonly phone: HTMLElement;
  /** This covers the view and holds tools, switches, progress and messages. */
  readonly overlay: HTMLElement;
  readonly foot: HTMLElement;
  readonly dialogs: HTMLElement;
  /** Keeps the picture at the size of the view, in device pixels. */
  follow(viewer: Viewer, pixelRatio?: number): void;
}

/** A higher ratio is not visible and would cost too much time on the GPU. */
const largestPixelRatio = 2;

export function createLayout(root: HTMLElement): Layout {
  const top = append(root, 'header', 'top');
  const left = append(root, 'aside', 'left');
  const view = append(root, 'main', 'view');
  const right = append(root, 'aside', 'right');
  const phone = append(root, 'nav', 'phone');
  const foot = append(root, 'div', 'foot');
  right.id = 'inspector';
  phone.setAttribute('aria-label', 'Panels');
  left.setAttribute('aria-label', 'Characters and joints');
  right.setAttribute('aria-label', 'Inspector');
  const canvas = view.appendChild(document.createElement('canvas'));
  canvas.className = 'scene';
  canvas.tabIndex = 0;
  // The canvas handles keys of its own, which a screen reader must pass on to it.
  canvas.setAttribute('role', 'application');
  canvas.setAttribute('aria-label', '3D view');
  const overlay = append(view, 'div', 'overlay');
  return {
    root,
    top,
    view,
    canvas,
    left,
    right,
    phone,
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
