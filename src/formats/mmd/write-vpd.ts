import { encodeText } from './encode-name.ts';
import { signature, type Vpd } from './vpd-parts.ts';

/** As MikuMikuDance writes its files: in Shift-JIS, with CRLF and its comments. */
export function writeVpd({ model, bones, morphs }: Vpd): Uint8Array {
  const lines = [
    signature,
    '',
    `${model};\t\t// 親ファイル名`,
    `${bones.length};\t\t\t\t// 総ポーズボーン数`,
    '',
    ...bones.flatMap(({ name, position, rotation }, index) => [
      `Bone${index}{${name}`,
      `  ${position.map(decimal).join(',')};\t\t\t\t// trans x,y,z`,
      `  ${rotation.map(decimal).join(',')};\t\t// Quaternion x,y,z,w`,
      '}',
      '',
    ]),
    ...morphs.flatMap(({ name, weight }, index) => [
      `Morph${index}{${name}`,
      `  ${decimal(weight)};\t\t\t\t// weight`,
      '}',
      '',
    ]),
  ];
  return encodeText(lines.map((line) => `${line}\r\n`).join(''));
}

/** Six digits after the point, as MikuMikuDance has them, or as many as the value needs. */
function decimal(value: number): string {
  const short = value.toFixed(6);
  if (Object.is(Number(short), value)) return short;
  return Object.is(value, -0) ? '-0.000000' : String(value);
}
