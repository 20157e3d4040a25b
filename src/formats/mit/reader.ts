import type {
  CharacterParts,
  MaterialParts,
  MeshParts,
  SkeletonParts,
} from '../../core/character-parts.ts';
import type { Diagnostic, Parsed } from '../../core/diagnostics.ts';
import { loadPart } from '../../core/failure.ts';
import type { Limits } from '../../core/limits.ts';
import { groupFiles } from '../belonging/group-files.ts';
import { baseName, extensionOf } from '../file-entry.ts';
import type { FileEntry, FileGroup, FormatReader } from '../format.ts';
import { readObj } from '../obj/read-obj.ts';
import { type ExpectedColumns, readAttach } from './attach.ts';
import { libraryExtension, partKinds } from './kinds.ts';
import { readSkel } from './skel.ts';

/** MIT 6.837 assignment 2: `Model1.skel`, `Model1.obj`, `Model1.attach`. */
export const mitReader: FormatReader = {
  group: (files) => groupFiles(files, partKinds, groupByLibraries),
  read: readGroup,
};

/** Few characters have materials, so the first picture does not wait for this code. */
async function groupByLibraries(files: readonly FileEntry[]): Promise<readonly FileGroup[]> {
  const { groupWithLibraries } = await loadPart(import('./group-files.ts'));
  return groupWithLibraries(files);
}

async function readGroup(group: FileGroup, limits: Limits): Promise<Parsed<CharacterParts>> {
  const skeleton = await readPart(group, '.skel', (file, bytes) => readSkel(file, bytes, limits));
  const libraries = filesOf(group, libraryExtension);
  const bare = await readPart(group, '.obj', (file, bytes) =>
    readObj(file, bytes, limits, libraries.length > 0),
  );
  const mesh = await withMaterials(bare, libraries, limits);
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
    missing: partKinds.single.filter((kind) => filesOf(group, kind).length === 0),
  };
  if (value.skeleton || value.mesh) return { value, diagnostics };
  if (skin.value) diagnostics.push(aloneDiagnostic(skin.value.file, 'weights alone'));
  const isLibraryAlone = libraries.length === group.files.length;
  if (isLibraryAlone) diagnostics.push(aloneDiagnostic(group.files[0]!.path, 'materials alone'));
  return { diagnostics };
}

/** Most meshes have no materials, so the first picture does not wait for the code that reads them. */
async function withMaterials(
  mesh: Parsed<MeshParts>,
  libraries: readonly FileEntry[],
  limits: Limits,
): Promise<Parsed<MeshParts>> {
  if (!mesh.value || libraries.length === 0) return mesh;
  const { readMtl } = await loadPart(import('../obj/read-mtl.ts'));
  const diagnostics = [...mesh.diagnostics];
  const materials: MaterialParts[] = [];
  for (const library of libraries) {
    const parsed = await readMtl(baseName(library.path), await library.bytes(), limits);
    diagnostics.push(...parsed.diagnostics);
    materials.push(...(parsed.value ?? []));
  }
  return { value: { ...mesh.value, materials }, diagnostics };
}

/** One column for every joint except the first. */
function columnsOf({ file, joints }: SkeletonParts): ExpectedColumns {
  const reason = `${joints.length} joints in ${file}, less the root`;
  return { count: joints.length - 1, reason };
}

function aloneDiagnostic(path: string, found: string): Diagnostic {
  return {
    severity: 'warning',
    code: 'file/missing',
    file: baseName(path),
    expected: 'a .skel and an .obj with it',
    found,
    effect: 'there is nothing to show',
  };
}

async function readPart<T>(
  group: FileGroup,
  kind: string,
  read: (file: string, bytes: Uint8Array) => Parsed<T> | Promise<Parsed<T>>,
): Promise<Parsed<T>> {
  const [file] = filesOf(group, kind);
  return file ? read(baseName(file.path), await file.bytes()) : { diagnostics: [] };
}

function filesOf(group: FileGroup, kind: string): FileEntry[] {
  return group.files.filter(({ path }) => extensionOf(path) === kind);
}
