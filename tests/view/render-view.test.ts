import fc from 'fast-check';
import { expect, it } from 'vitest';
import { startCamera } from '../../src/document/camera.ts';
import { sideBySide } from '../../src/view/render-view.ts';

const view = { camera: startCamera, overrides: {} };

it('views under wipes all have the whole place, and their parts fill it without a gap', () => {
  const place = fc.double({ min: 0, max: 1, noNaN: true });
  const size = fc.integer({ min: 1, max: 5000 });
  fc.assert(
    fc.property(
      size,
      size,
      fc.array(place, { minLength: 1, maxLength: 3 }),
      (width, height, at) => {
        const edges = [0, ...at.sort((a, b) => a - b), 1];
        const spans = at.concat(1).map((_, i) => [edges[i]!, edges[i + 1]!] as const);
        const views = sideBySide(
          spans.map((span) => ({ ...view, span })),
          width,
          height,
        );
        let end = 0;
        for (const { viewport, clip } of views) {
          expect(viewport).toEqual({ x: 0, y: 0, width, height });
          expect(clip!.x).toBe(end);
          expect(clip!.width).toBeGreaterThanOrEqual(0);
          end += clip!.width;
        }
        expect(end).toBe(width);
      },
    ),
  );
});
