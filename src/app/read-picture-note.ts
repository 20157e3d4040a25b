import { DiagnosticLog } from '../core/diagnostics.ts';
import { checkVersion, type JsonValue } from '../formats/json/decoder.ts';
import { parseJson } from '../formats/json/parse-json.ts';
import type { JsonText } from './sort-files.ts';

export interface ReadNote {
  /** The id of the bundled character, if the picture shows one. */
  readonly bundled?: string;
  /** The pose, to be decoded when its skeleton is open; absent if the note is damaged. */
  readonly pose?: JsonValue;
  /** The problems of the note, and later those of its pose. */
  readonly log: DiagnosticLog;
}

/**
 * Reads what a PNG of an early Sinew remembers, or reports why it can't be read. Later ones remember
 * their whole scene.
 */
export function readPictureNote({ path, text }: JsonText): ReadNote {
  const log = new DiagnosticLog(path);
  const effect = 'the pose of the picture is not used';
  const json = parseJson(text, { log, area: 'pose', effect });
  const members = json?.record('an object with "name" and "pose"');
  if (!json || !members || !checkVersion(members)) return { log };
  json.member('name').text('"name" to be a text');
  const bundled = members.get('bundled')?.text('"bundled" to be the id of a character');
  const pose = json.member('pose');
  pose.record('"pose" to be an object');
  if (log.failed) return { log };
  return { log, pose, ...(bundled !== undefined && { bundled }) };
}
