import type { Mesh } from '../../core/mesh.ts';
import type { Skin } from '../../core/skin.ts';
import type { MethodUse, PosedStreams, SkinningMethod, WasmPlan } from '../method.ts';
import { mixVertices } from '../mix-vertices.ts';
import { WasmSkin } from './wasm-skin.ts';

/** Skins by the function that gave their rows; null if there was not enough memory. */
type SkinCopies = Map<WasmPlan['rows'], WasmSkin | null>;

/**
 * The WebAssembly kernel. It keeps a copy of every skin that it has deformed, which is released
 * with the skin.
 */
export class WasmSkinning {
  /** It can be passed to other threads. */
  readonly module: WebAssembly.Module;
  private readonly copies = new WeakMap<Skin, SkinCopies>();

  constructor(module: WebAssembly.Module) {
    this.module = module;
  }

  /** @param bytes kernel.as, compiled; rejects where WebAssembly or its vectors are missing */
  static async compile(bytes: Uint8Array): Promise<WasmSkinning> {
    return new WasmSkinning(await WebAssembly.compile(bytes));
  }

  /**
   * Computes what `method.deform` does, bit by bit. Returns false if it can't, because the method
   * has no such kernel for the skin or there is not enough memory; then nothing is written.
   */
  deform(
    { wasm: plan }: Pick<SkinningMethod, 'wasm'>,
    mesh: Mesh,
    skin: Skin,
    palette: Float32Array,
    out: PosedStreams,
    use: MethodUse,
  ): boolean {
    const share = plan?.mixture?.share(use.settings) ?? 1;
    const own = plan && share > 0 ? this.copyOf(skin, mesh, plan) : null;
    const other = plan?.mixture && share < 1 ? plan.mixture.other : null;
    const added = other && this.copyOf(skin, mesh, other);
    if ((share > 0 && !own) || (share < 1 && !added)) return false;
    if (own?.deform(plan!, mesh, palette, out, plan!.centers?.(use.extra)))
      plan!.complete?.(mesh, skin, palette, out, use);
    if (!own) added?.deform(other!, mesh, palette, out);
    else if (added) {
      const mixed = streamsLike(out);
      added.deform(other, mesh, palette, mixed);
      mixVertices(mixed, share, out);
    }
    return true;
  }

  private copyOf(skin: Skin, mesh: Mesh, plan: WasmPlan): WasmSkin | null {
    const { rows } = plan;
    let copies = this.copies.get(skin);
    if (!copies) this.copies.set(skin, (copies = new Map() as SkinCopies));
    let copy = copies.get(rows);
    if (copy === undefined || copy?.fits(mesh) === false) {
      copies.set(rows, (copy = this.tryCopy(skin, mesh, plan)));
    }
    return copy;
  }

  private tryCopy(skin: Skin, mesh: Mesh, plan: WasmPlan): WasmSkin | null {
    try {
      const rows = plan.rows(skin);
      const entryCount = skin.paletteJoint.length;
      const hasCenters = plan.centers !== undefined;
      return rows && new WasmSkin(this.module, mesh, rows, entryCount, hasCenters);
    } catch (error) {
      if (error instanceof RangeError) return null;
      throw error;
    }
  }
}

function streamsLike({ positions, normals }: PosedStreams): PosedStreams {
  return {
    positions: new Float32Array(positions.length),
    normals: normals && new Float32Array(normals.length),
  };
}
