import type { Kernels } from '../evaluation/kernels.ts';
import address from '../skinning/wasm/kernel.as?url';
import { WasmSkinning } from '../skinning/wasm/wasm-skinning.ts';
import { fetchChecked } from './fetch-file.ts';

/**
 * Loads the WebAssembly kernel, which computes the same bits as the strict kernels in less time.
 * Where it can't be fetched or compiled, the strict kernels go on, and nothing is missing.
 */
export async function loadWasmKernel(kernels: Kernels): Promise<void> {
  try {
    const response = await fetchChecked(new URL(address, location.href));
    kernels.wasm = await WasmSkinning.compile(new Uint8Array(await response.arrayBuffer()));
  } catch {
    kernels.wasm = null;
  }
}
