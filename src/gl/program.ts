import type { Gpu } from './gpu.ts';

export interface ProgramSources {
  /** The name for error messages. */
  readonly name: string;
  readonly vertex: string;
  readonly fragment: string;
  /** The outputs of the vertex stage that transform feedback writes, each to its own buffer. */
  readonly feedback?: readonly string[];
}

export type UniformValue = number | boolean | ArrayLike<number>;

/** A uniform of a program, none of which is an array. */
interface Uniform {
  readonly location: WebGLUniformLocation;
  readonly type: number;
  /** An array that is overwritten at every use, so that no use allocates one. */
  readonly staging: Float32Array;
}

/**
 * A program. Uniforms are set and attributes are found by name. It is compiled and linked beside the
 * page, which waits for the result at the program's first use and not before.
 */
export class Program {
  readonly name: string;
  private readonly gl: WebGL2RenderingContext;
  private readonly handle: WebGLProgram;
  private readonly untrack: () => void;
  private readonly uniforms = new Map<string, Uniform>();
  private readonly attributes = new Map<string, number>();
  /** The stages, until it is known that they were linked. */
  private stages: readonly Stage[];

  constructor(gpu: Gpu, sources: ProgramSources) {
    const { gl } = gpu;
    this.gl = gl;
    this.name = sources.name;
    this.handle = gl.createProgram();
    this.untrack = gpu.track('program');
    this.stages = [
      compile(gl, gl.VERTEX_SHADER, sources.vertex, `${sources.name} (vertex)`),
      compile(gl, gl.FRAGMENT_SHADER, sources.fragment, `${sources.name} (fragment)`),
    ];
    for (const { shader } of this.stages) gl.attachShader(this.handle, shader);
    if (sources.feedback) {
      gl.transformFeedbackVaryings(this.handle, [...sources.feedback], gl.SEPARATE_ATTRIBS);
    }
    gl.linkProgram(this.handle);
  }

  use(): void {
    this.finish();
    this.gl.useProgram(this.handle);
  }

  /** The attribute's location, or -1 if the program does not read it. */
  attribute(name: string): number {
    this.finish();
    return this.attributes.get(name) ?? -1;
  }

  /** Sets uniforms of this program, which must be in use. Unknown names are ignored. */
  set(values: Readonly<Record<string, UniformValue>>): void {
    for (const name in values) {
      const uniform = this.uniforms.get(name);
      if (uniform) this.setUniform(uniform, values[name]!);
    }
  }

  bindBlock(name: string, binding: number): void {
    const index = this.gl.getUniformBlockIndex(this.handle, name);
    if (index !== this.gl.INVALID_INDEX) {
      this.gl.uniformBlockBinding(this.handle, index, binding);
    }
  }

  dispose(): void {
    this.deleteStages();
    this.gl.deleteProgram(this.handle);
    this.untrack();
  }

  /** Waits until the program is linked, which a driver may do beside the page's own work. */
  finish(): void {
    if (this.stages.length === 0) return;
    const { gl, handle, name } = this;
    if (!gl.getProgramParameter(handle, gl.LINK_STATUS) && !gl.isContextLost()) {
      for (const stage of this.stages) expectCompiled(gl, stage);
      throw new Error(`${name} does not link: ${gl.getProgramInfoLog(handle) ?? ''}`);
    }
    this.deleteStages();
    this.findUniforms();
    this.findAttributes();
  }

  private deleteStages(): void {
    for (const { shader } of this.stages) this.gl.deleteShader(shader);
    this.stages = [];
  }

  private setUniform({ location, type, staging }: Uniform, value: UniformValue): void {
    const { gl } = this;
    if (typeof value === 'object') staging.set(value);
    else staging[0] = Number(value);
    switch (type) {
      case gl.FLOAT:
        gl.uniform1fv(location, staging);
        break;
      case gl.FLOAT_VEC2:
        gl.uniform2fv(location, staging);
        break;
      case gl.FLOAT_VEC3:
        gl.uniform3fv(location, staging);
        break;
      case gl.FLOAT_VEC4:
        gl.uniform4fv(location, staging);
        break;
      case gl.FLOAT_MAT4:
        gl.uniformMatrix4fv(location, false, staging);
        break;
      default:
        gl.uniform1i(location, staging[0]!);
    }
  }

  private findUniforms(): void {
    const { gl, handle } = this;
    const count = (gl.getProgramParameter(handle, gl.ACTIVE_UNIFORMS) as number | null) ?? 0;
    for (let i = 0; i < count; i++) {
      const info = gl.getActiveUniform(handle, i);
      const location = info && gl.getUniformLocation(handle, info.name);
      if (!location) continue; // a member of a block
      const staging = new Float32Array(floatsOf(gl, info.type));
      this.uniforms.set(info.name, { location, type: info.type, staging });
    }
  }

  private findAttributes(): void {
    const { gl, handle } = this;
    const count = (gl.getProgramParameter(handle, gl.ACTIVE_ATTRIBUTES) as number | null) ?? 0;
    for (let i = 0; i < count; i++) {
      const info = gl.getActiveAttrib(handle, i);
      if (info) this.attributes.set(info.name, gl.getAttribLocation(handle, info.name));
    }
  }
}

/** The number of components of a uniform type. */
function floatsOf(gl: WebGL2RenderingContext, type: number): number {
  switch (type) {
    case gl.FLOAT_VEC2:
      return 2;
    case gl.FLOAT_VEC3:
      return 3;
    case gl.FLOAT_VEC4:
      return 4;
    case gl.FLOAT_MAT4:
      return 16;
    default:
      return 1;
  }
}

interface Stage {
  /** The name for error messages. */
  readonly name: string;
  readonly shader: WebGLShader;
  readonly source: string;
}

/** Begins to compile; whether that succeeds is asked only if the program does not link. */
function compile(gl: WebGL2RenderingContext, type: number, source: string, name: string): Stage {
  const shader = gl.createShader(type);
  if (!shader) throw new Error(`${name}: the context is lost`);
  gl.shaderSource(shader, source);
  gl.compileShader(shader);
  return { name, shader, source };
}

function expectCompiled(gl: WebGL2RenderingContext, { name, shader, source }: Stage): void {
  if (gl.getShaderParameter(shader, gl.COMPILE_STATUS)) return;
  const numbered = source.split('\n').map((line, index) => `${index + 1}: ${line}`);
  throw new Error(`${name}: ${gl.getShaderInfoLog(shader) ?? ''}\n${numbered.join('\n')}`);
}
