import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { JsonValue } from '../../formats/json/decoder.ts';
import { parseJson } from '../../formats/json/parse-json.ts';
import type { Source } from '../scene.ts';
import type { ViewState } from '../view-state.ts';
import { type ActorDescription, readActor } from './actor-json.ts';
import { readFields } from './fields.ts';
import { migrated, sceneVersion } from './migrations.ts';
import { sourceJson } from './source-json.ts';
import { plainSurroundings, type Surroundings, surroundingsJson } from './surroundings-json.ts';
import { viewJson } from './view-json.ts';

/** A scene that was read; its characters may still be on their way. */
export interface SceneDescription {
  /** Where each character comes from, or nothing where the scene does not say it. */
  readonly characters: readonly (Source | undefined)[];
  readonly actors: readonly ActorDescription[];
  readonly surroundings: Surroundings;
  /** Absent if the scene does not say how it is viewed. */
  readonly view?: ViewState;
  /** The problems so far; those of the actors follow when their characters are there. */
  readonly log: DiagnosticLog;
}

/** More than a page can show; a link of a few kilobytes could name very many. */
const mostActors = 1000;

/**
 * Reads a scene. A value that is wrong is reported and affects only itself. A text that is no scene,
 * or one of a newer version, gives none.
 *
 * @param file what the text is called in messages
 */
export function readScene(file: string, text: string): Parsed<SceneDescription> {
  const log = new DiagnosticLog(file);
  const effect = 'the scene is not opened';
  const read = parseJson(text, { log, area: 'scene', effect });
  const json = read && presentForm(read);
  const listed = json?.member('actors').list(mostActors, listOf('actors'));
  const sources = json?.member('characters').list(mostActors, listOf('characters'));
  if (!json || !listed || !sources) return { diagnostics: log.diagnostics };
  const inPart = json.reporting({ effect: 'this part is left out' });
  const characters = sources.map((_, at) =>
    sourceJson.read(inPart.member('characters').member(at)),
  );
  const actors = listed.flatMap((_, at) => {
    const actor = readActor(inPart.member('actors').member(at));
    return actor && hasCharacter(actor, sources.length) ? [actor] : [];
  });
  const others = readFields(surroundingsJson, inPart, ['version', 'characters', 'actors', 'view']);
  const view = json.record('an object')?.has('view')
    ? viewJson.read(inPart.member('view'))
    : undefined;
  const surroundings = { ...plainSurroundings, ...others };
  const value = { characters, actors, surroundings, ...(view && { view }), log };
  return { value, diagnostics: log.diagnostics };
}

function listOf(name: string): string {
  return `"${name}" to be a list of at most ${mostActors}`;
}

/** The value in the form of this version; nothing if it is none, or of a newer version. */
function presentForm(json: JsonValue): JsonValue | undefined {
  const members = json.record('an object with "characters" and "actors"');
  if (!members) return undefined;
  const stated = members.get('version');
  // The note of early pictures states no version.
  const version = stated?.value ?? (members.has('actors') ? sceneVersion : 0);
  if (version === sceneVersion) return json;
  if (!Number.isSafeInteger(version) || (version as number) < 0) {
    (stated ?? json).fail('json', '"version" to be a whole number');
    return undefined;
  }
  if ((version as number) > sceneVersion) {
    const expected = `"version" to be at most ${sceneVersion} (a newer Sinew wrote this)`;
    (stated ?? json).fail('version', expected);
    return undefined;
  }
  const record = json.value as Readonly<Record<string, unknown>>;
  return new JsonValue(migrated(record, version as number), json.source);
}

function hasCharacter({ character, json }: ActorDescription, count: number): boolean {
  if (character < count) return true;
  json.member('character').fail('index', `an index of the ${count} characters`);
  return false;
}
