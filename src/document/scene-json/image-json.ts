import type { CharacterImage } from '../../core/character.ts';
import { fromBase64url, toBase64url } from '../base64url.ts';
import { type Codec, text } from './codec.ts';

/** An image with the bytes of its file in base64url. */
export const imageJson: Codec<CharacterImage> = {
  write: (image) => ({ name: image.name, bytes: encoded(image) }),
  read(json) {
    if (!json.record('an image with "name" and "bytes"')) return undefined;
    const name = text.read(json.member('name'));
    const member = json.member('bytes');
    const expected = 'the bytes of an image in base64url';
    const written = member.text(expected);
    const bytes = written === undefined ? undefined : fromBase64url(written);
    if (written !== undefined && !bytes) member.fail('json', expected, 'another text');
    return name === undefined || !bytes ? undefined : { name, textures: [], bytes };
  },
};

/** A scene is written after every change, but its images stay the same. */
function encoded(image: CharacterImage): string {
  let written = texts.get(image);
  if (written === undefined) texts.set(image, (written = toBase64url(image.bytes)));
  return written;
}

const texts = new WeakMap<CharacterImage, string>();
