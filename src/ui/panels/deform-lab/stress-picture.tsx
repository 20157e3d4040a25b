import { useLayoutEffect, useRef } from 'preact/hooks';
import type { Picture } from '../../../view/picture/encode-picture.ts';

interface StressPictureProperties {
  readonly picture: Picture;
  readonly label: string;
}

/** A picture of a pose by a method. */
export function StressPicture({ picture, label }: StressPictureProperties) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const { width, height, pixels } = picture;
  useLayoutEffect(() => {
    canvas.current?.getContext('2d')?.putImageData(new ImageData(pixels, width, height), 0, 0);
  }, [pixels]);
  return <canvas ref={canvas} width={width} height={height} role="img" aria-label={label} />;
}
