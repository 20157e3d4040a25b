import type { Character } from '../../core/character.ts';
import type { CharacterParts, SkeletonParts } from '../../core/character-parts.ts';
import type { Diagnostic, Parsed } from '../../core/diagnostics.ts';
import type { Limits } from '../../core/limits.ts';
import { noJoint } from '../../core/skin.ts';
import { formatExtensions } from '../extensions.ts';
import { baseName, extensionOf } from '../file-entry.ts';
import type { FileEntry, FileGroup, Format, OutputFile, Written } from '../format.ts';
import { groupByStem } from '../group-by-stem.ts';
import { readObj } from '../obj/read-obj.ts';
import { writeObj } from '../obj/write-obj.ts';
import { skelDialect } from '../skel-dialect.ts';
import { type ExpectedColumns, readAttach } from './attach.ts';
import { attachLosses } from './attach-losses.ts';
import { objLosses } from './losses.ts';
import { readSkel } from './skel.ts';
import { skelLosses } from './skel-losses.ts';
import { writeAttach } from './write-attach.ts';
import { writeSkel } from './write-skel.ts';

const kinds = formatExtensions.mit;

/** MIT 6.837 assignment 2: `Model1.skel`, `Model1.obj`, `Model1.attach`. */
export const mitFormat: Format = {
  id: 'mit',
  label: 'MIT 6.837',
  extensions: kinds,
  claim: (files) => groupByStem(files.filter(isMitFile), kinds),
  read: readGroup,
  write: writeCharacter,
};

function isMitFile(file: FileEntry): boolean {
  const extension = extensionOf(file.path);
  if (extension === '.skel') return skelDialect(file) === 'mit';
  return kinds.some((kind) => kind === extension);
}

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

/** A column for every joint but the first. */
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
  read: (file: string, bytes: Uint8Array) => Parsed<T>,
): Promise<Parsed<T>> {
  const file = fileOf(group, kind);
  return file ? read(baseName(file.path), await file.bytes()) : { diagnostics: [] };
}

function fileOf(group: FileGroup, kind: string): FileEntry | undefined {
  return group.files.find(({ path }) => extensionOf(path) === kind);
}

/** A file for each part that there is. */
function writeCharacter({ name, skeleton, mesh, skin }: Character): Written {
  const files: OutputFile[] = [];
  const losses: Diagnostic[] = [];
  if (skeleton.jointCount > 0) {
    const path = `${name}.skel`;
    files.push({ path, bytes: writeSkel(skeleton) });
    losses.push(...skelLosses(path, skeleton));
  }
  if (mesh.pointCount > 0) {
    const path = `${name}.obj`;
    files.push({ path, bytes: writeObj(mesh) });
    losses.push(...objLosses(path, mesh));
  }
  const followsJoints = !skin.paletteJoint.includes(noJoint);
  if (skeleton.jointCount > 0 && mesh.pointCount > 0 && followsJoints) {
    const path = `${name}.attach`;
    files.push({ path, bytes: writeAttach(skin, skeleton) });
    losses.push(...attachLosses(path, skin, skeleton));
  }
  return { files, losses };
}
