import { signal } from '@preact/signals-core';
import { hashOf } from '../core/hash-of.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import type { SkinningMethod } from '../skinning/method.ts';
import { Preparation, type Prepare, prepareInPlace } from './preparation.ts';

/** So many results are kept for skins that are opened again; they are small beside their meshes. */
const keptCount = 24;

interface PreparationsOptions {
  /** Computes what a method prepares for a skin; in place, if absent. */
  readonly prepare?: Prepare;
  /**
   * Resolves after a moment in which weights that are being changed change again; at once, if absent.
   */
  readonly pause?: () => Promise<void>;
  /** This is called once for each that fails. */
  readonly onFailed?: (error: unknown) => void;
}

/**
 * What methods prepare for skins, such as centers of rotation. Equal skins of equal meshes have one
 * result, which is computed once, also for a copy of the character and a file that is opened again.
 * While weights of a mesh are being changed, the last result for it stands in, and nothing is computed
 * before there is a pause.
 */
export class Preparations {
  /** Those that are being computed. */
  readonly running = signal<readonly Preparation[]>([]);
  private readonly bySkin = new WeakMap<Skin, Map<SkinningMethod, Preparation>>();
  /** By method and content, the last used at the end. */
  private readonly byContent = new Map<string, Preparation>();
  private readonly lastOf = new WeakMap<Mesh, Map<SkinningMethod, unknown>>();
  private readonly options: PreparationsOptions;

  constructor(options: PreparationsOptions = {}) {
    this.options = options;
  }

  of(method: SkinningMethod, mesh: Mesh, skin: Skin): Preparation {
    const known = this.bySkin.get(skin) ?? new Map<SkinningMethod, Preparation>();
    this.bySkin.set(skin, known);
    let preparation = known.get(method);
    if (!preparation) known.set(method, (preparation = this.ofContent(method, mesh, skin)));
    return preparation;
  }

  /** Ends all that are being computed; linear blend goes on in their place. */
  cancel(): void {
    for (const preparation of this.running.peek()) preparation.cancel();
  }

  private ofContent(method: SkinningMethod, mesh: Mesh, skin: Skin): Preparation {
    const { start, entries, weights, paletteJoint } = skin;
    const { positions, indices, pointOf } = mesh;
    const parts = [positions, indices, pointOf, start, entries, weights, paletteJoint];
    const key = `${method.id} ${hashOf(parts)}`;
    const preparation = this.byContent.get(key) ?? this.begin(key, method, mesh, skin);
    this.byContent.delete(key);
    this.byContent.set(key, preparation);
    const [oldest] = this.byContent.keys();
    if (this.byContent.size > keptCount) this.byContent.delete(oldest!);
    return preparation;
  }
  private begin(key: string, method: SkinningMethod, mesh: Mesh, skin: Skin): Preparation {
    const { prepare = prepareInPlace, pause, onFailed } = this.options;
    const last = this.lastOf.get(mesh) ?? new Map<SkinningMethod, unknown>();
    this.lastOf.set(mesh, last);
    const standIn = last.get(method);
    return new Preparation(method.id, (control) => prepare(method, mesh, skin, control), standIn, {
      beforeStart: async () => (standIn === undefined ? undefined : pause?.()),
      onStarted: (each) => (this.running.value = [...this.running.peek(), each]),
      onArrived: (value) => last.set(method, value),
      onEnded: (each, isThere) => {
        this.running.value = this.running.peek().filter((other) => other !== each);
        // What a drag passed over leaves no trace.
        if (!isThere && this.byContent.get(key) === each) this.byContent.delete(key);
      },
      onFailed,
    });
  }
}
