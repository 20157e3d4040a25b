import type { Page } from '@playwright/test';

/** What a page holds on to that a leak would let grow. */
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

/** From now on pages count listeners on lasting targets, workers and blob URLs. */
export async function countHoldings(page: Page): Promise<void> {
  await page.addInitScript(count);
}

export function holdingsOf(page: Page): Promise<Holdings> {
  return page.evaluate(() => ({ objects: window.sinew.liveObjects, ...window.holdings() }));
}

/** It runs in the page, before the scripts of the page. */
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
