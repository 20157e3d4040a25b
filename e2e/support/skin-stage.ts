import type { Page } from '@playwright/test';

/** The inputs of one run of the skin stage, as reported by WebGL itself. */
export interface SkinRun {
  readonly vertexCount: number;
  /**
   * Active uniform blocks that have a buffer bound, with the size in bytes that the shader
   * declares.
   */
  readonly blocks: readonly { readonly name: string; readonly size: number }[];
  /** Active samplers. */
  readonly textures: readonly string[];
}

declare global {
  interface Window {
    skinRuns: SkinRun[];
  }
}

/** Makes pages record every draw with transform feedback in `window.skinRuns` from now on. */
export async function watchSkinStage(page: Page): Promise<void> {
  await page.addInitScript(() => {
    window.skinRuns = [];
    const { prototype } = WebGL2RenderingContext;
    const { beginTransformFeedback, drawArrays } = Object.getOwnPropertyDescriptors(prototype);
    let running = false;
    prototype.beginTransformFeedback = function (mode) {
      running = true;
      beginTransformFeedback.value!.call(this, mode);
    };
    prototype.drawArrays = function (mode, first, count) {
      if (running) window.skinRuns.push(describe(this, count));
      running = false;
      drawArrays.value!.call(this, mode, first, count);
    };

    function describe(gl: WebGL2RenderingContext, vertexCount: number): SkinRun {
      const program = gl.getParameter(gl.CURRENT_PROGRAM) as WebGLProgram;
      const numbers = (parameter: number): number[] =>
        Array.from({ length: gl.getProgramParameter(program, parameter) as number }, (_, i) => i);
      const blocks = numbers(gl.ACTIVE_UNIFORM_BLOCKS).map((index) => {
        const parameter = (name: number): number =>
          gl.getActiveUniformBlockParameter(program, index, name) as number;
        const binding = parameter(gl.UNIFORM_BLOCK_BINDING);
        const isBound = gl.getIndexedParameter(gl.UNIFORM_BUFFER_BINDING, binding) !== null;
        return {
          name: `${gl.getActiveUniformBlockName(program, index)}${isBound ? '' : ' (unbound)'}`,
          size: parameter(gl.UNIFORM_BLOCK_DATA_SIZE),
        };
      });
      const textures = numbers(gl.ACTIVE_UNIFORMS)
        .map((index) => gl.getActiveUniform(program, index)!)
        .filter(({ type }) => type === gl.SAMPLER_2D)
        .map(({ name }) => name);
      return { vertexCount, blocks, textures };
    }
  });
}

export function skinRuns(page: Page): Promise<SkinRun[]> {
  return page.evaluate(() => window.skinRuns);
}
