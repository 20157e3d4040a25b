import { expect, test } from 'vitest';
import { stripGlsl } from '../../tools/vite-glsl.ts';

test('comments, blank lines and spaces are removed; directives and the order of lines stay', () => {
  const source = `// What it is for.
#include "lib/palette.glsl"

#if ROWS > 0 // in a block
  float a/* one */= 1.0; /* two
  lines */ float b = a / 2.0;
#endif
`;
  expect(stripGlsl(source)).toBe(
    '#include "lib/palette.glsl"\n#if ROWS > 0\nfloat a=1.0;float b=a/2.0;\n#endif\n',
  );
});

test('what a minus needs stays', () => {
  expect(stripGlsl('float c = a - -b; // a sum\n')).toBe('float c=a - -b;\n');
});

test('a macro of several lines stays one', () => {
  expect(stripGlsl('#define TWICE(x) \\\n  x; \\\n  x;\n')).toBe(
    '#define TWICE(x) \\\nx; \\\nx;\n',
  );
});

test('lines may end as on Windows', () => {
  expect(stripGlsl('// a\r\nvoid f();\r\n')).toBe('void f();\n');
});
