import type { Page } from '@playwright/test';

/** Text of a shader, and what stands in its place in a faulty one. */
export type Replacement = readonly [text: string, faulty: string];

declare global {
  interface Window {
    faults: readonly Replacement[];
    /** Texts that were found in a shader, and replaced. */
    planted: Set<string>;
  }
}

/** From now on what pages give WebGL to compile goes through `window.faults`. */
export async function allowFaults(page: Page): Promise<void> {
  await page.addInitScript(() => {
    window.faults = [];
    window.planted = new Set();
    const { prototype } = WebGL2RenderingContext;
    const { shaderSource } = Object.getOwnPropertyDescriptors(prototype);
    prototype.shaderSource = function (shader, source) {
      let faulty = source;
      for (const [text, replacement] of window.faults) {
        if (faulty.includes(text)) window.planted.add(text);
        faulty = faulty.replaceAll(text, () => replacement);
      }
      shaderSource.value!.call(this, shader, faulty);
    };
  });
}

/** Takes the context away and gives it back: the page compiles every shader anew, with the fault. */
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
    // WebGL restores no context before the event of its loss is over.
    setTimeout(() => context.restoreContext());
    await restored;
  }, replacements);
}

export function plantedTexts(page: Page): Promise<string[]> {
  return page.evaluate(() => [...window.planted]);
}
