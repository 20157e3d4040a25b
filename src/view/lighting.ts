import { mat4, vec3 } from 'gl-matrix';
import type { Ambient, Light } from '../document/environment.ts';
import type { Gpu } from '../gl/gpu.ts';
import { DepthTarget } from '../gl/depth-target.ts';
import type { UniformValue } from '../gl/program.ts';
import { Texture } from '../gl/texture.ts';
import type { CharacterView } from './character-view.ts';
import type { ContactShadow } from './contact-shadow.ts';
import type { Frame } from './frame.ts';
import { viewFromScene } from './camera.ts';
import { lightDirection } from './light-direction.ts';
import type { Programs } from './programs.ts';
import { refinement } from './refinement.ts';
import { type Subject, subjectOf } from './subject.ts';
import { linear } from './theme.ts';

const keyShadowSize = 1024;
const keyShadowUnit = 2;
const contactShadowUnit = 3;

/** The studio's lights and the shadows that they cast, which are redrawn only if a pose changed. */
export class Lighting {
  private readonly gpu: Gpu;
  private readonly gl: WebGL2RenderingContext;
  private readonly programs: Programs;
  private readonly keyShadow: DepthTarget;
  /** Null until its code is loaded. */
  private contactShadow: ContactShadow | null = null;
  /** What is bound meanwhile. */
  private readonly noShadow: Texture;
  private readonly clipFromScene = new Float32Array(16);
  private keyShadowStep = 0;
  private shown = '';
  private shownContact = '';

  constructor(gpu: Gpu, programs: Programs) {
    this.gpu = gpu;
    this.gl = gpu.gl;
    this.programs = programs;
    this.keyShadow = new DepthTarget(gpu, keyShadowSize);
    this.noShadow = new Texture(gpu, 'color-rgba8', 1, 1);
  }

  /** Draws and binds the shadows of a frame, and returns the uniforms that every pass may read. */
  prepare(frame: Frame): Readonly<Record<string, UniformValue>> {
    const { showSkin, environment } = frame.options;
    const [key, fill, rim] = environment.lights.map(lightUniforms) as [
      LightUniforms,
      LightUniforms,
      LightUniforms,
    ];
    const versions = frame.characters.map(({ revision }) => revision);
    const casters = showSkin && environment.shadow.kind === 'mapped' ? frame.characters : [];
    const contact = this.contact();
    // Once refined, casters leave out other triangles.
    const shadows = `${contact !== null} ${casters.length} ${key.direction.join()} ${versions.join()}`;
    const evaluations = frame.characters.map(({ evaluation }) => evaluation);
    if (shadows !== this.shown) {
      this.shown = shadows;
      const subject = subjectOf(evaluations);
      this.clipFromScene.set(keyClipFromScene(subject, key.direction));
      this.keyShadowStep = (3.5 * 2 * subject.radius) / keyShadowSize;
      this.drawKeyShadow(casters);
    }
    if (contact && shadows !== this.shownContact && frame.detail === 'full') {
      this.shownContact = shadows;
      contact.draw(casters, subjectOf(evaluations));
    }
    this.keyShadow.bind(keyShadowUnit);
    (contact?.texture ?? this.noShadow).bind(contactShadowUnit);
    return {
      keyDirection: key.direction,
      keyColor: key.color,
      fillDirection: fill.direction,
      fillColor: fill.color,
      rimDirection: rim.direction,
      rimColor: rim.color,
      ambientColor: lightColor(environment.ambient),
      keyClipFromScene: this.clipFromScene,
      keyShadowStep: this.keyShadowStep,
      keyShadow: keyShadowUnit,
      contactShadow: contactShadowUnit,
      contactSquare: contact?.square ?? [0, 0, 1],
      // A draft has no contact shadow if the pose has changed since it was drawn.
      contactStrength: this.shownContact === shadows ? 1 : 0,
    };
  }

  dispose(): void {
    this.keyShadow.dispose();
    this.noShadow.dispose();
    this.contactShadow?.dispose();
  }

  private contact(): ContactShadow | null {
    const code = refinement.loaded;
    if (code) this.contactShadow ??= new code.ContactShadow(this.gpu, this.programs);
    return this.contactShadow;
  }

  private drawKeyShadow(casters: readonly CharacterView[]): void {
    const { gl } = this;
    this.keyShadow.begin();
    const program = this.programs.pass('key-shadow');
    program.use();
    program.set({ clipFromScene: this.clipFromScene });
    // The offset moves the casters away from the light, by their slope and a constant step, so that
    // they do not shadow themselves.
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(2, 2);
    for (const caster of casters) caster.drawCaster(program);
    gl.disable(gl.POLYGON_OFFSET_FILL);
  }
}

/** Returns a projection without perspective that looks along the key light at the subject. */
function keyClipFromScene({ center, radius }: Subject, keyDirection: vec3): mat4 {
  const eye = vec3.scaleAndAdd(new Float64Array(3), center, keyDirection, 4 * radius);
  const look = vec3.scale(new Float64Array(3), keyDirection, -1);
  const right = vec3.cross(new Float64Array(3), [0, 1, 0], keyDirection);
  vec3.normalize(right, right);
  const up = vec3.cross(new Float64Array(3), keyDirection, right);
  const view = viewFromScene({ right, up, look }, eye);
  const bounds = [-radius, radius, -radius, radius, radius, 9 * radius] as const;
  return mat4.multiply(new Float64Array(16), mat4.ortho(new Float64Array(16), ...bounds), view);
}

interface LightUniforms {
  /** The unit vector to the light, in scene space. */
  readonly direction: [number, number, number];
  /** The linear color, multiplied by the intensity. */
  readonly color: readonly number[];
}

function lightUniforms(light: Light): LightUniforms {
  return { direction: lightDirection(light), color: lightColor(light) };
}

function lightColor({ color, intensity }: Ambient): number[] {
  return linear(color).map((channel) => channel * intensity);
}
