import type { Character, CharacterImage } from '../../core/character.ts';
import type { ActorLook } from '../../document/actor-look.ts';
import type { Gpu } from '../../gl/gpu.ts';
import type { UniformValue } from '../../gl/program.ts';
import type { GpuPools } from '../gpu-pools.ts';
import type { OnImage } from '../lazy-dress.ts';
import { polishOf } from '../polish.ts';
import type { Cover } from './cover.ts';
import { mappingOf, projectionOf } from './mapping.ts';
import './shaders.ts';
import { SurfaceTextures } from './surface-textures.ts';

const patterns = ['image', 'checker', 'uv'] as const;
const projections = ['uv', 'box', 'cylinder'] as const;

/** What covers the surfaces of an actor: the textures of its files, or what its look says. */
export class ActorDress {
  private readonly character: Character;
  private readonly texturesOf: (images: readonly CharacterImage[]) => SurfaceTextures;
  private readonly ofFiles: SurfaceTextures;
  private own: SurfaceTextures | null = null;
  private image: CharacterImage | null = null;

  constructor(gpu: Gpu, pools: GpuPools, character: Character, onImage: OnImage) {
    this.character = character;
    this.texturesOf = (images) => new SurfaceTextures(gpu, pools, images, onImage);
    this.ofFiles = this.texturesOf(character.images);
  }

  /** Settles when all pictures are decoded and, where possible, are in textures. */
  get loaded(): Promise<unknown> {
    return Promise.all([this.ofFiles.loaded, this.own?.loaded]);
  }

  /** Loads the image of a look in place of the former one. */
  wear({ image }: ActorLook): void {
    if (image === this.image) return;
    this.image = image;
    const former = this.own;
    this.own = image && this.texturesOf([image]);
    former?.dispose();
  }

  /**
   * Returns what covers a surface, or nothing if it shows its color.
   *
   * @param texture the name of its texture in the character's images
   */
  coverOf(texture: string | undefined, look: ActorLook): Cover | undefined {
    if (look.surface === 'clay') return undefined;
    if (look.surface === 'file') {
      const found = this.ofFiles.find(texture);
      return found && { program: 'mesh-textured', uniforms: {}, bind: (unit) => found.bind(unit) };
    }
    if (look.surface === 'uv' && !this.character.mesh.uvs) return undefined;
    const image = this.own?.find(look.image?.name);
    if (look.surface === 'image' && !image) return undefined;
    return {
      program: 'mesh-mapped',
      uniforms: this.mappedUniforms(look),
      bind: (unit) => image?.bind(unit),
    };
  }

  dispose(): void {
    this.ofFiles.dispose();
    this.own?.dispose();
  }

  private mappedUniforms(look: ActorLook): Record<string, UniformValue> {
    const { mesh } = this.character;
    const { origin, height } = mappingOf(mesh);
    return {
      ...polishOf(look),
      albedo: [1, 1, 1],
      pattern: patterns.indexOf(look.surface as (typeof patterns)[number]),
      projection: projections.indexOf(projectionOf(mesh, look)),
      repeats: look.repeats,
      mapOrigin: origin,
      mapScale: 1 / height,
    };
  }
}
