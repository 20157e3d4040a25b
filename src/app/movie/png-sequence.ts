import { encodePicture } from '../../view/picture/encode-picture.ts';
import { frameName, GrowingZip } from './growing-zip.ts';
import type { OpenSink } from './movie-format.ts';

/** Writes each frame as the PNG that a picture of its time would be. */
export const openPngSequence: OpenSink = ({ plan: { count } }) => {
  const zip = new GrowingZip();
  return Promise.resolve({
    async add(frame) {
      const png = await encodePicture(await frame.picture(), 'png');
      const bytes = new Uint8Array(await png.arrayBuffer());
      zip.add(frameName('frame', frame.index, count, '.png'), bytes, false);
    },
    finish: () => Promise.resolve(zip.finish()),
    close: () => zip.close(),
  });
};
