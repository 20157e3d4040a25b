import type { Page } from '@playwright/test';

declare global {
  interface Window {
    /** The number of skins that the WebAssembly kernel has taken. */
    wasmSkins: number;
    /** Whether the kernel is compiled. */
    isKernelCompiled: boolean;
  }
}

/** Counts what the WebAssembly kernel does in pages that are opened from now on. */
export async function watchWasmKernel(page: Page): Promise<void> {
  await page.addInitScript(() => {
    window.wasmSkins = 0;
    window.isKernelCompiled = false;
    const { compile, Instance } = WebAssembly;
    WebAssembly.compile = async (bytes: BufferSource) => {
      const module = await compile(bytes);
      setTimeout(() => (window.isKernelCompiled = true));
      return module;
    };
    WebAssembly.Instance = new Proxy(Instance, {
      construct(target, parameters: [WebAssembly.Module]) {
        window.wasmSkins++;
        return new target(...parameters);
      },
    });
  });
}

/** From now on, the page computes vertices with the WebAssembly kernel. */
export async function wasmKernelReady(page: Page): Promise<void> {
  await page.waitForFunction(() => window.isKernelCompiled);
}
