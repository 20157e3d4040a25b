import type { Page } from '@playwright/test';

/** The resources of a page that would grow if something leaked. */
export interface Holdings {
  /** Live WebGL objects by kind. */
  readonly objects: Readonly<Record<string, number>>;
  readonly listeners: number;
  readonly workers: number;
  readonly urls: number;
}

declare global {
  interface Window {
    holdings(): Omit<Holdings, 'objects'>;
  }
}

/** Makes pages count listeners on long-lived targets, workers and blob URLs from now on. */
export async function countHoldings(page: Page): Promise<void> {
  await page.addInitScript(count);
}

export function holdingsOf(page: Page): Promise<Holdings> {
  return page.evaluate(() => ({ objects: window.sinew.liveObjects, ...window.holdings() }));
}

/** Runs in the page, before the page's scripts. */
function count(): void {
  const counts = { listeners: 0, workers: 0, urls: 0 };
  const lasting = (target: EventTarget): boolean =>
    target === window || target === document || target instanceof HTMLCanvasElement;
  const { addEventListener, removeEventListener } = EventTarget.prototype;
  EventTarget.prototype.addEventListener = function (this: EventTarget, ...parameters) {
    if (lasting(this)) counts.listeners++;
    addEventListener.apply(this, parameters);
  };
  EventTarget.prototype.removeEventListener = function (this: EventTarget, ...parameters) {
    if (lasting(this)) counts.listeners--;
    removeEventListener.apply(this, parameters);
  };
  window.Worker = class extends Worker {
    constructor(...parameters: ConstructorParameters<typeof Worker>) {
      super(...parameters);
      counts.workers++;
    }
    override terminate(): void {
      counts.workers--;
      super.terminate();
    }
  };
  const { createObjectURL, revokeObjectURL } = URL;
  URL.createObjectURL = (object: Blob) => {
    counts.urls++;
    return createObjectURL(object);
  };
  URL.revokeObjectURL = (url: string) => {
    counts.urls--;
    revokeObjectURL(url);
  };
  window.holdings = () => ({ ...counts });
}
