import type { JsonValue } from '../../formats/json/decoder.ts';
import type { Source, SourceFile } from '../scene.ts';
import { type Codec, listOf, text, textLike } from './codec.ts';
import { readFields, writeFields } from './fields.ts';

const sourceFile: Codec<SourceFile> = {
  write: (file) => writeFields(fileFields, file),
  read(json) {
    const { path, sha256 } = readFields(fileFields, json) ?? {};
    if (path === undefined) json.fail('json', '"path" to be the path of a file');
    return path === undefined ? undefined : { path, sha256: sha256 ?? '' };
  },
};

const fileFields = {
  path: text,
  sha256: textLike(/^([\da-f]{64})?$/, 'a SHA-256 in lower-case hexadecimal digits'),
};

const files = listOf(sourceFile, 10_000);

/** Where a character comes from: the id of a bundled one, or files with their SHA-256. */
export const sourceJson: Codec<Source> = {
  write: (source) =>
    source.kind === 'bundled' ? { bundled: source.id } : { files: files.write(source.files) },
  read(json) {
    const members = json.record('an object with "bundled" or "files"');
    const [bundled, listed] = [members?.get('bundled'), members?.get('files')];
    if (bundled) return bundledSource(bundled);
    const read = listed && files.read(listed);
    if (members && !listed) json.fail('json', '"bundled" or "files"');
    return read && { kind: 'files', files: read };
  },
};

function bundledSource(json: JsonValue): Source | undefined {
  const id = text.read(json);
  return id === undefined ? undefined : { kind: 'bundled', id };
}
