import type { MorphParts } from '../../core/character-parts.ts';
import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { Limits } from '../../core/limits.ts';
import type { MmdDisplay, MmdEnglish, MmdMorphs, MmdPhysics } from './mmd-parts.ts';
import type { BinaryReader } from '../binary/binary-reader.ts';
import { noDisplay, readDisplay } from './display.ts';
import { readEnglish } from './english.ts';
import { noMorphs, readMorphs } from './morphs.ts';
import { readPhysics } from './physics.ts';
import { readToons } from './toons.ts';

/** The sections of a PMD after its bones, as far as the file is valid. */
export interface PmdExtras {
  morphs: readonly MorphParts[];
  readonly mmd: {
    morphs: MmdMorphs;
    display: MmdDisplay;
    english?: MmdEnglish;
    toons: readonly string[];
    physics?: MmdPhysics;
  };
}

/**
 * Reads the sections after the IK chains, up to the first invalid one. That section and all later
 * ones are left out with a warning. English names, toons and physics may be missing, together with
 * everything after them.
 */
export function readExtras(
  reader: BinaryReader,
  file: string,
  pointCount: number,
  boneCount: number,
  log: DiagnosticLog,
  limits: Limits,
): PmdExtras {
  const extras: PmdExtras = {
    morphs: noMorphs.morphs,
    mmd: { morphs: noMorphs.mmd, display: noDisplay, toons: [] },
  };
  const { mmd } = extras;

  reader.beLenient(without('morphs'));
  const morphs = readMorphs(reader, file, pointCount, limits.coordinate, log);
  if (!morphs) return extras;
  extras.morphs = morphs.morphs;
  mmd.morphs = morphs.mmd;

  reader.beLenient(without('lists of morphs and bones'));
  const morphCount = morphs.mmd.listed.length;
  const display = readDisplay(reader, boneCount, morphCount, log);
  if (!display) return extras;
  mmd.display = display;

  if (reader.left === 0) return extras;
  const groups = display.groupNames.length;
  const counts = { bones: boneCount, morphs: morphCount, groups };
  reader.beLenient(without('English names'));
  const english = readEnglish(reader, counts, log, without('English names'));
  if (english === undefined) return extras;
  if (english) mmd.english = english;

  if (reader.left === 0) return extras;
  reader.beLenient(without('names of toon textures'));
  const toons = readToons(reader);
  if (!toons) return extras;
  mmd.toons = toons;

  if (reader.left === 0) return extras;
  reader.beLenient(without('physics'));
  const physics = readPhysics(reader, boneCount, log);
  if (!physics) return extras;
  mmd.physics = physics;

  if (reader.left > 0) {
    const { offset, left } = reader;
    const effect = 'they are left out';
    const expected = 'the end of the file';
    log.warn({ code: 'pmd/trailing', offset, expected, found: `${left} more bytes`, effect });
  }
  return extras;
}

function without(what: string): string {
  return `the file is read without its ${what} and what follows`;
}
