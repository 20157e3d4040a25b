import type { Pass } from '../pass.ts';
import { palette } from '../theme.ts';

/** The posed skin, matte clay, smooth or faceted. */
export const meshPass: Pass = {
  id: 'mesh',
  create(_, programs) {
    return {
      draw(frame) {
        if (!frame.options.showSkin) return;
        const program = programs.pass('mesh');
        program.use();
        program.set(frame.uniforms);
        program.set({ albedo: palette.clay, faceted: frame.options.faceted });
        for (const { display, skinned } of frame.characters) {
          program.set({ sceneFromCharacter: display.sceneFromCharacter });
          skinned.draw(program);
        }
      },
      dispose: () => undefined,
    };
  },
};
