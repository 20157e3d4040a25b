import { mat4, vec3 } from 'gl-matrix';
import type { Gpu } from '../gl/gpu.ts';
import { DepthTarget } from '../gl/depth-target.ts';
import type { UniformValue } from '../gl/program.ts';
import { ContactShadow } from './contact-shadow.ts';
import type { Frame } from './frame.ts';
import type { Programs } from './programs.ts';
import { type Subject, subjectOf } from './subject.ts';

const keyShadowSize = 1024;
const keyShadowUnit = 2;
const contactShadowUnit = 3;

/** Directions to the lights, scene space: characters face +z, so that the key is at their right. */
const keyDirection = directionTo(-18, 48);
const fillDirection = directionTo(88, 16);
const rimDirection = directionTo(168, 34);

/** The studio's lights and the shadows they throw, drawn anew only when a pose changed. */
export class Lighting {
  private readonly gl: WebGL2RenderingContext;
  private readonly programs: Programs;
  private readonly keyShadow: DepthTarget;
  private readonly contactShadow: ContactShadow;
  private readonly clipFromScene = new Float32Array(16);
  private shown = '';

  constructor(gpu: Gpu, programs: Programs) {
    this.gl = gpu.gl;
    this.programs = programs;
    this.keyShadow = new DepthTarget(gpu, keyShadowSize);
    this.contactShadow = new ContactShadow(gpu, programs);
  }

  /** Draws the shadows of a frame, binds them, and tells the uniforms that every pass may read. */
  prepare(frame: Frame): Readonly<Record<string, UniformValue>> {
    const versions = frame.characters.map(({ state, version }) => `${state.id}.${version}`);
    const key = `${frame.options.showSkin} ${versions.join()}`;
    if (key !== this.shown) {
      this.shown = key;
      const casters = frame.options.showSkin ? frame.characters : [];
      const subject = subjectOf(frame.characters);
      this.drawKeyShadow({ ...frame, characters: casters }, subject);
      this.contactShadow.draw(casters, subject);
    }
    this.keyShadow.bind(keyShadowUnit);
    this.contactShadow.texture.bind(contactShadowUnit);
    return {
      keyDirection,
      fillDirection,
      rimDirection,
      keyClipFromScene: this.clipFromScene,
      keyShadow: keyShadowUnit,
      contactShadow: contactShadowUnit,
      contactSquare: this.contactShadow.square,
    };
  }

  dispose(): void {
    this.keyShadow.dispose();
    this.contactShadow.dispose();
  }

  private drawKeyShadow({ characters }: Frame, subject: Subject): void {
    const { gl } = this;
    mat4.copy(this.clipFromScene, keyClipFromScene(subject));
    this.keyShadow.begin();
    const program = this.programs.pass('key-shadow');
    program.use();
    program.set({ clipFromScene: this.clipFromScene });
    // Slope and step push the caster back, so that it does not shade itself.
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(2, 2);
    for (const { display, skinned } of characters) {
      program.set({ sceneFromCharacter: display.sceneFromCharacter });
      skinned.draw(program);
    }
    gl.disable(gl.POLYGON_OFFSET_FILL);
  }
}

/** Looks along the key light at the subject, without perspective. */
function keyClipFromScene({ center, radius }: Subject): mat4 {
  const eye = vec3.scaleAndAdd(new Float64Array(3), center, keyDirection, 4 * radius);
  const view = mat4.lookAt(new Float64Array(16), eye, center, [0, 1, 0]);
  const bounds = [-radius, radius, -radius, radius, radius, 9 * radius] as const;
  return mat4.multiply(new Float64Array(16), mat4.ortho(new Float64Array(16), ...bounds), view);
}

/** @param azimuth degrees about +y from +z towards +x; @param elevation degrees above the floor */
function directionTo(azimuth: number, elevation: number): [number, number, number] {
  const [around, above] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  const level = Math.cos(above);
  return [Math.sin(around) * level, Math.sin(above), Math.cos(around) * level];
}
