import type { Character } from '../../core/character.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import type { Pose } from '../../core/pose.ts';
import { jointRange } from '../../core/pose.ts';
import { ballValue, quaternionOf } from '../ball-values.ts';
import { setSlides } from './vpd-slides.ts';
import { cutName } from './encode-name.ts';
import { Findings } from './findings.ts';
import { mirrorPoint, mirrorRotation } from './mirror.ts';
import type { Vpd, VpdBone } from './vpd-parts.ts';

/** Bytes that a PMD has for a name; a pose has all of it. */
const fieldSize = 20;

/** How far the length of a quaternion of six digits may be from 1. */
const roundedLength = 1e-4;

/**
 * Puts a pose of MikuMikuDance onto what a character shows. Bones and morphs that it does not name
 * stay as they are shown, as in MikuMikuDance, whose files often have a hand or a face alone.
 */
export function fitVpd(
  file: string,
  { bones, morphs }: Vpd,
  character: Character,
  shown: Required<Pose>,
): Parsed<Required<Pose>> {
  const log = new DiagnosticLog(file);
  const { skeleton } = character;
  const pose = { q: shown.q.slice(), morphWeights: shown.morphWeights.slice() };
  const jointOf = finder(boneNames(character));
  const morphOf = finder(character.morphs.map(({ name }) => name));
  const findings = new PoseFindings();
  for (const bone of bones) {
    const joint = jointOf(bone.name);
    if (joint === undefined) findings.missing.add(bone.line, bone.name);
    else setBone(joint, bone);
  }
  for (const { name, line, weight } of morphs) {
    const morph = morphOf(name);
    if (morph === undefined) findings.missingMorphs.add(line, name);
    else pose.morphWeights[morph] = weight;
  }
  findings.warn(log);
  return log.finish(pose);

  function setBone(joint: number, { name, line, position, rotation }: VpdBone): void {
    const at = ballValue(skeleton, joint);
    const length = Math.hypot(...rotation);
    if (length < roundedLength) findings.lengths.add(line, `${length} for "${name}"`);
    else if (at < 0) findings.fixed.add(line, name);
    else {
      if (Math.abs(length - 1) > roundedLength)
        findings.rounded.add(line, `${length} for "${name}"`);
      pose.q.set(quaternionOf([...mirrorRotation(rotation)]), at);
    }
    const [from, to] = jointRange(skeleton, joint);
    if (!setSlides(skeleton, joint, pose.q.subarray(from, to), mirrorPoint(position))) {
      findings.immovable.add(line, name);
    }
  }
}

/** The names of a character's bones as its file has them, in the order of its joints. */
export function boneNames({ skeleton }: Character): readonly string[] {
  const { names, fileNames } = skeleton;
  return fileNames.length === names.length ? fileNames : names;
}

/**
 * Returns a function that finds the index of the first thing with a name, or whose name is as much
 * of it as a PMD holds.
 */
function finder(names: readonly string[]): (name: string) => number | undefined {
  const known = new Map<string, number>();
  names.forEach((name, index) => {
    if (!known.has(name)) known.set(name, index);
  });
  return (name) => known.get(name) ?? known.get(cutName(name, fieldSize));
}

/** What a character does not take of a pose. */
class PoseFindings {
  readonly missing = new Findings('line');
  readonly missingMorphs = new Findings('line');
  readonly lengths = new Findings('line');
  readonly rounded = new Findings('line');
  readonly fixed = new Findings('line');
  readonly immovable = new Findings('line');

  warn(log: DiagnosticLog): void {
    const out = 'left out';
    this.missing.warn(log, 'vpd/unknown-joint', 'names of bones of the character', out);
    this.missingMorphs.warn(log, 'vpd/unknown', 'names of morphs of the character', out);
    this.lengths.warn(
      log,
      'vpd/singular',
      'quaternions with a length',
      'the bones stay as they are',
    );
    this.rounded.warn(log, 'vpd/range', 'quaternions of length 1', 'made so');
    this.fixed.warn(log, 'vpd/ignored', 'rotations of bones that turn freely', out);
    this.immovable.warn(log, 'vpd/ignored', 'offsets of bones that can be moved', out);
  }
}
