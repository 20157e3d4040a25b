import { Failure } from '../../core/failure.ts';
import { writeObj } from '../../formats/obj/write-obj.ts';
import { frameName, GrowingZip } from './growing-zip.ts';
import type { OpenSink } from './movie-format.ts';

/** Writes the posed mesh of the selected character at each frame, as its export would. */
export const openObjSequence: OpenSink = ({ plan: { count } }) => {
  const zip = new GrowingZip();
  return Promise.resolve({
    add(frame) {
      const posed = frame.selected();
      const mesh = posed?.state.character.mesh;
      if (!posed || !mesh || mesh.pointCount === 0) {
        throw new Failure('There is no mesh to export');
      }
      const { positions } = posed.vertices();
      const bytes = writeObj(mesh, { positions, normals: null });
      zip.add(frameName('mesh', frame.index, count, '.obj'), bytes, true);
      return Promise.resolve();
    },
    finish: () => Promise.resolve(zip.finish()),
    close: () => zip.close(),
  });
};
