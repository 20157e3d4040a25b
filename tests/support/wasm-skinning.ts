import { WasmSkinning } from '../../src/skinning/wasm/wasm-skinning.ts';
import { compileKernel } from '../../tools/compile-kernel.ts';

/** The WebAssembly kernel of this tree, or of a changed source. */
export async function compiledSkinning(
  source?: string,
  optimizeLevel?: number,
): Promise<WasmSkinning> {
  return WasmSkinning.compile(await compileKernel(source, optimizeLevel));
}
