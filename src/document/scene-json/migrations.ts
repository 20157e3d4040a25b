import type { JsonNode } from '../../formats/json/decoder.ts';

type Members = Readonly<Record<string, unknown>>;

/**
 * Each turns the form of one version into that of the next; the first one starts at version 0. To
 * change what a field means, raise the version by a row here.
 */
const migrations: readonly ((members: Members) => Members)[] = [fromPictureNote];

/** The version of scene JSON that this Sinew writes. */
export const sceneVersion = migrations.length;

/** Returns the present form of a value of an older version. Its parts know no places any more. */
export function migrated(value: Members, version: number): JsonNode {
  const steps = migrations.slice(version);
  return { value: steps.reduce((members, step) => step(members), value) };
}

/** Version 0 is the note of early pictures: a bundled character, its name and its POSE.json. */
function fromPictureNote({ bundled, name, pose }: Members): Members {
  const source = bundled === undefined ? { files: [] } : { bundled };
  return { version: 1, characters: [source], actors: [{ character: 0, name, pose }] };
}
