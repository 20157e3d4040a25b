import type { MaterialParts } from '../../core/character-parts.ts';
import type { Scanner } from './scanner.ts';

const isKeyword = (word: string): boolean => word === 'texture';

/**
 * Reads `NAME { texture FILE }`. The image is only searched for among the files that were opened
 * with it.
 */
export function readMaterial(scanner: Scanner): MaterialParts | undefined {
  const { reader } = scanner;
  let name = '';
  if (!scanner.openIfAny()) {
    reader.next();
    if (!reader.isWord) scanner.fail('token', 'a name');
    else {
      name = reader.unquoted();
      scanner.open();
    }
  }
  let texture: string | undefined;
  while (scanner.sound()) {
    const word = scanner.keyword(isKeyword);
    if (reader.isClose) return { name, ...(texture === undefined ? {} : { texture }) };
    if (word === 'texture') {
      reader.next();
      if (reader.isWord) texture = reader.unquoted();
      else scanner.fail('token', 'the name of an image');
    } else if (reader.isWord) scanner.skipUnknown(isKeyword);
    else scanner.fail('token', '"}" for the material');
  }
  return undefined;
}
