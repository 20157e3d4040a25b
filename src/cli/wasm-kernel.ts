import { WasmSkinning } from '../skinning/wasm/wasm-skinning.ts';

/**
 * Compiles the WebAssembly kernel, or takes what was compiled before. Returns null where that is not
 * possible; then the strict kernels compute the same.
 */
export async function wasmKernel(): Promise<WasmSkinning | null> {
  try {
    const { compileKernel } = await import('../../tools/compile-kernel.ts');
    return await WasmSkinning.compile(await compileKernel());
  } catch {
    return null;
  }
}
