import type { CharacterParts, SkeletonParts } from '../../core/character-parts.ts';
import type { Diagnostic, Parsed } from '../../core/diagnostics.ts';
import type { Limits } from '../../core/limits.ts';
import { groupFiles } from '../belonging/group-files.ts';
import { formatExtensions } from '../extensions.ts';
import { baseName, extensionOf } from '../file-entry.ts';
import type { FileEntry, FileGroup, FormatReader } from '../format.ts';
import { readObj } from '../obj/read-obj.ts';
import { type ExpectedColumns, readAttach } from './attach.ts';
import { readSkel } from './skel.ts';

const kinds = formatExtensions.mit;

/** MIT 6.837 assignment 2: `Model1.skel`, `Model1.obj`, `Model1.attach`. */
export const mitReader: FormatReader = {
  group: (files) => groupFiles(files, { single: kinds, many: [] }),
  read: readGroup,
};

async function readGroup(group: FileGroup, limits: Limits): Promise<Parsed<CharacterParts>> {
  const skeleton = await readPart(group, '.skel', (file, bytes) => readSkel(file, bytes, limits));
  const mesh = await readPart(group, '.obj', (file, bytes) => readObj(file, bytes, limits));
  const columns = skeleton.value && columnsOf(skeleton.value);
  const skin = await readPart(group, '.attach', (file, bytes) =>
    readAttach(file, bytes, columns, limits),
  );
  const diagnostics = [skeleton, mesh, skin].flatMap((part) => part.diagnostics);
  const value: CharacterParts = {
    name: group.name,
    ...(skeleton.value ? { skeleton: skeleton.value } : {}),
    ...(mesh.value ? { mesh: mesh.value } : {}),
    ...(skin.value ? { skin: skin.value } : {}),
    missing: kinds.filter((kind) => !fileOf(group, kind)),
  };
  if (value.skeleton || value.mesh) return { value, diagnostics };
  if (skin.value) diagnostics.push(aloneDiagnostic(skin.value.file));
  return { diagnostics };
}

/** One column for every joint except the first. */
function columnsOf({ file, joints }: SkeletonParts): ExpectedColumns {
  const reason = `${joints.length} joints in ${file}, less the root`;
  return { count: joints.length - 1, reason };
}

function aloneDiagnostic(file: string): Diagnostic {
  return {
    severity: 'warning',
    code: 'file/missing',
    file,
    expected: 'a .skel and an .obj with it',
    found: 'weights alone',
    effect: 'there is nothing to show',
  };
}

async function readPart<T>(
  group: FileGroup,
  kind: string,
  read: (file: string, bytes: Uint8Array) => Parsed<T> | Promise<Parsed<T>>,
): Promise<Parsed<T>> {
  const file = fileOf(group, kind);
  return file ? read(baseName(file.path), await file.bytes()) : { diagnostics: [] };
}

function fileOf(group: FileGroup, kind: string): FileEntry | undefined {
  return group.files.find(({ path }) => extensionOf(path) === kind);
}
