import { expect, it } from 'vitest';
import { buildCharacter } from '../../../src/core/build-character.ts';
import { writeSkin } from '../../../src/formats/cse169/write-skin.ts';

it('writes more vertices than a call can have arguments', () => {
  const vertexCount = 150_000;
  const { value } = buildCharacter({
    name: 'large',
    missing: [],
    mesh: {
      file: 'large.obj',
      positions: new Float32Array(vertexCount * 3),
      cornerPoints: Uint32Array.of(0, 1, 2),
    },
  });
  const text = new TextDecoder().decode(writeSkin(value!));
  expect(text.startsWith(`positions ${vertexCount} {\n`)).toBe(true);
});
