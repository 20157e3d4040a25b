import type { Mesh } from '../../core/mesh.ts';
import type { InfluenceRows, Skin } from '../../core/skin.ts';
import type { PosedStreams, SkinningMethod } from '../method.ts';
import { WasmSkin } from './wasm-skin.ts';

/** Skins by the function that gave their rows; null if there was not enough memory. */
type SkinCopies = Map<(skin: Skin) => InfluenceRows, WasmSkin | null>;

/**
 * The WebAssembly kernel. It keeps a copy of every skin that it has deformed, which is released
 * with the skin.
 */
export class WasmSkinning {
  private readonly module: WebAssembly.Module;
  private readonly copies = new WeakMap<Skin, SkinCopies>();

  private constructor(module: WebAssembly.Module) {
    this.module = module;
  }

  /** @param bytes kernel.as, compiled; rejects where WebAssembly or its vectors are missing */
  static async compile(bytes: Uint8Array): Promise<WasmSkinning> {
    return new WasmSkinning(await WebAssembly.compile(bytes));
  }

  /**
   * Computes what `method.deform` does, bit by bit. Returns false if it can't, because the method
   * has no such kernel or there is not enough memory; then nothing is written.
   */
  deform(
    method: SkinningMethod,
    mesh: Mesh,
    skin: Skin,
    palette: Float32Array,
    out: PosedStreams,
  ): boolean {
    const copy = method.wasm ? this.copyOf(skin, mesh, method.wasm.rows) : null;
    copy?.deform(method, mesh, palette, out);
    return copy !== null;
  }

  private copyOf(skin: Skin, mesh: Mesh, rows: (skin: Skin) => InfluenceRows): WasmSkin | null {
    let copies = this.copies.get(skin);
    if (!copies) this.copies.set(skin, (copies = new Map() as SkinCopies));
    let copy = copies.get(rows);
    if (copy === undefined || copy?.fits(mesh) === false) {
      copies.set(rows, (copy = this.tryCopy(skin, mesh, rows)));
    }
    return copy;
  }

  private tryCopy(skin: Skin, mesh: Mesh, rows: (skin: Skin) => InfluenceRows): WasmSkin | null {
    try {
      return new WasmSkin(this.module, mesh, rows(skin), skin.paletteJoint.length);
    } catch (error) {
      if (error instanceof RangeError) return null;
      throw error;
    }
  }
}
