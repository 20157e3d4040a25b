import type { Character } from '../../core/character.ts';
import { defaultLimits } from '../../core/limits.ts';
import { type Influence, influencesOf, noJoint, type Skin } from '../../core/skin.ts';
import type { JsonValue } from '../../formats/json/decoder.ts';
import { indexOfKey, keyAt } from '../../formats/json/keys.ts';
import { sameValue } from '../../core/same-value.ts';
import { changedSkin } from '../skin-edits.ts';
import { index, numberWithin } from './codec.ts';

const weightJson = numberWithin(-defaultLimits.weight, defaultLimits.weight);

interface WrittenRow {
  readonly point: number;
  readonly joints: readonly string[];
  readonly weights: readonly number[];
}

/** Writes the influences of the points whose weights are not those of the file. */
export function writeSkin(skin: Skin, character: Character): readonly WrittenRow[] {
  const names = entryNames(character);
  const rows: WrittenRow[] = [];
  for (let point = 0; point + 1 < skin.start.length; point++) {
    const row = influencesOf(skin, point);
    if (sameValue(row, influencesOf(character.skin, point))) continue;
    rows.push({
      point,
      joints: row.map(({ entry }) => keyAt(names, entry)),
      weights: row.map(({ weight }) => weight),
    });
  }
  return rows;
}

/** Reads what `writeSkin` wrote; a row that does not fit is reported and left out. */
export function readSkin(json: JsonValue, character: Character): Skin | null {
  const pointCount = character.skin.start.length - 1;
  const names = entryNames(character);
  const rows = new Map<number, readonly Influence[]>();
  for (const item of json.list(pointCount, 'a list of at most one row a vertex') ?? []) {
    const row = item.record('a row of weights') && readRow(item, names);
    const point = row && index.read(item.member('point'));
    if (!row || point === undefined) continue;
    if (point < pointCount) rows.set(point, row);
    else item.member('point').fail('index', `a vertex of the ${pointCount} of the character`);
  }
  return changedSkin(character, character.skin, rows);
}

function readRow(json: JsonValue, names: readonly string[]): readonly Influence[] | undefined {
  const joints = json.member('joints').list(names.length, 'a list of joints');
  const weights = json.member('weights').list(names.length, 'a weight for each joint');
  if (!joints || !weights) return undefined;
  if (joints.length === 0) {
    json.member('joints').fail('json', 'at least one joint');
    return undefined;
  }
  const row: Influence[] = [];
  for (const [i, joint] of joints.entries()) {
    const entry = typeof joint.value === 'string' ? indexOfKey(names, joint.value) : -1;
    if (entry < 0) joint.fail('unknown-joint', 'the name of a joint, or # and its index');
    const own = weights[i] ?? json.member('weights');
    const weight = weightJson.read(own);
    if (entry < 0 || weight === undefined) return undefined;
    row.push({ entry, weight });
  }
  return row;
}

/** The names of the palette's entries, by which rows are written. */
function entryNames({ skeleton, skin }: Character): readonly string[] {
  return Array.from(skin.paletteJoint, (joint) =>
    joint === noJoint ? 'no joint' : skeleton.names[joint]!,
  );
}
