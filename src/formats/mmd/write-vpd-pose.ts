import type { Character } from '../../core/character.ts';
import type { Diagnostic } from '../../core/diagnostics.ts';
import { jointRange, type Pose } from '../../core/pose.ts';
import { ballValue, type Quaternion } from '../ball-values.ts';
import type { Written } from '../format.ts';
import { lost } from '../lost.ts';
import { boneNames } from './fit-vpd.ts';
import { fittedText } from './encode-name.ts';
import { mirrorPoint, mirrorRotation } from './mirror.ts';
import type { Vpd } from './vpd-parts.ts';
import { slidesOf } from './vpd-slides.ts';
import { writeVpd } from './write-vpd.ts';

/** Longer than any text in the file. */
const anyLength = 4096;

/** Writes the pose of a whole character whose joints are balls, with all of its morphs. */
export function writeVpdPose(character: Character, pose: Required<Pose>): Written {
  const vpd = vpdOf(character, pose);
  const file = `${character.name}.vpd`;
  return { files: [{ path: file, bytes: writeVpd(vpd) }], losses: lossesOf(vpd, file) };
}

/** In the order of the character's file. */
function vpdOf(character: Character, { q, morphWeights }: Required<Pose>): Vpd {
  const { name, skeleton, morphs } = character;
  const names = boneNames(character);
  return {
    model: `${name}.osm`,
    bones: Array.from(skeleton.jointOfSource, (joint) => {
      const at = ballValue(skeleton, joint);
      const rotation = Array.from(q.subarray(at, at + 4)) as Quaternion;
      const values = q.subarray(...jointRange(skeleton, joint));
      return {
        name: names[joint]!,
        line: 0,
        position: mirrorPoint(slidesOf(skeleton, joint, values)),
        rotation: mirrorRotation(at < 0 ? [0, 0, 0, 1] : rotation),
      };
    }),
    morphs: morphs.map((morph, index) => ({
      name: morph.name,
      line: 0,
      weight: morphWeights[index]!,
    })),
  };
}

/** Names that are not read again as they were: with other characters, or more than once. */
function lossesOf({ bones, morphs }: Vpd, file: string): Diagnostic[] {
  const losses: Diagnostic[] = [];
  for (const [what, all] of [
    ['bones', bones],
    ['morphs', morphs],
  ] as const) {
    const names = all.map(({ name }) => name);
    const changed = names.filter(
      (name) => fittedText(name, anyLength) !== name || name.includes('//'),
    );
    const twice = names.filter((name, index) => names.indexOf(name) !== index);
    if (changed.length > 0) {
      losses.push(
        lost(file, `names of ${what} in Shift-JIS`, told(changed), 'they are not found again'),
      );
    }
    if (twice.length > 0) {
      losses.push(
        lost(
          file,
          `a name of its own for each of the ${what}`,
          told(twice),
          'only the first is posed',
        ),
      );
    }
  }
  return losses;
}

function told([first, ...others]: readonly string[]): string {
  return others.length > 0 ? `${first} and ${others.length} more` : first!;
}
