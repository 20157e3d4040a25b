import { DiagnosticLog } from '../core/diagnostics.ts';
import { checkVersion, type JsonValue } from '../formats/json/decoder.ts';
import { parseJson } from '../formats/json/parse-json.ts';
import type { JsonText } from './sort-files.ts';

export interface ReadNote {
  /** Id of a bundled character, where the picture is of one. */
  readonly bundled?: string;
  /** For the skeleton that it is of, once that is open; nothing where the note is damaged. */
  readonly pose?: JsonValue;
  /** What there is to say of the note, and then of its pose. */
  readonly log: DiagnosticLog;
}

/** What a PNG remembers, or why it can't be told. */
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
