import type { Page } from '@playwright/test';

/** A text of a shader, and its faulty replacement. */
export type Replacement = readonly [text: string, faulty: string];

declare global {
  interface Window {
    faults: readonly Replacement[];
    /** The texts that were found in a shader and replaced. */
    planted: Set<string>;
  }
}

/** Makes every shader source that pages compile pass through `window.faults` from now on. */
export async function allowFaults(page: Page): Promise<void> {
  await page.addInitScript(() => {
    window.faults = [];
    window.planted = new Set();
    const { prototype } = WebGL2RenderingContext;
    const { shaderSource } = Object.getOwnPropertyDescriptors(prototype);
    prototype.shaderSource = function (shader, source) {
      let faulty = source;
      for (const [text, replacement] of window.faults) {
        // The built shaders have few spaces.
        const loose = text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&').replace(/\s+/g, '\\s*');
        faulty = faulty.replaceAll(new RegExp(loose, 'g'), () => {
          window.planted.add(text);
          return replacement;
        });
      }
      shaderSource.value!.call(this, shader, faulty);
    };
  });
}

/**
 * Loses the context and restores it, so that the page compiles every shader again, with the fault.
 */
export function plantFault(page: Page, replacements: readonly Replacement[]): Promise<void> {
  return page.evaluate(async (replacements) => {
    window.faults = replacements;
    window.planted.clear();
    const canvas = document.querySelector('canvas')!;
    const happened = (name: string): Promise<unknown> =>
      new Promise((resolve) => {
        canvas.addEventListener(name, resolve, { once: true });
      });
    const context = canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    const lost = happened('webglcontextlost');
    context.loseContext();
    await lost;
    const restored = happened('webglcontextrestored');
    // WebGL can restore a context only after the event of its loss has been handled.
    setTimeout(() => context.restoreContext());
    await restored;
  }, replacements);
}

export function plantedTexts(page: Page): Promise<string[]> {
  return page.evaluate(() => [...window.planted]);
}
