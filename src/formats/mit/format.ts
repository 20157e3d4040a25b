import type { Character } from '../../core/character.ts';
import type { CharacterParts } from '../../core/character-parts.ts';
import { type Diagnostic, DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { noJoint } from '../../core/skin.ts';
import { formatExtensions } from '../extensions.ts';
import { baseName, extensionOf } from '../file-entry.ts';
import type { FileEntry, FileGroup, Format, OutputFile } from '../format.ts';
import { groupByStem } from '../group-by-stem.ts';
import { readObj } from '../obj/read-obj.ts';
import { writeObj } from '../obj/write-obj.ts';
import { skelDialect } from '../skel-dialect.ts';
import { type AttachParts, readAttach, writeAttach } from './attach.ts';
import { readSkel, writeSkel } from './skel.ts';

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

async function readGroup(group: FileGroup): Promise<Parsed<CharacterParts>> {
  const skeleton = await readPart(group, '.skel', readSkel);
  const mesh = await readPart(group, '.obj', readObj);
  const weights = await readPart(group, '.attach', readAttach);
  const diagnostics: Diagnostic[] = [
    ...skeleton.diagnostics,
    ...mesh.diagnostics,
    ...weights.diagnostics,
  ];
  const jointCount = skeleton.value?.joints.length;
  const skin = weights.value && checkColumns(weights.value, jointCount, diagnostics);
  const value: CharacterParts = {
    name: group.name,
    ...(skeleton.value ? { skeleton: skeleton.value } : {}),
    ...(mesh.value ? { mesh: mesh.value } : {}),
    ...(skin ? { skin } : {}),
    missing: kinds.filter((kind) => !fileOf(group, kind)),
  };
  if (value.skeleton || value.mesh) return { value, diagnostics };
  if (weights.value) diagnostics.push(aloneDiagnostic(weights.value.file));
  return { diagnostics };
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

/** A column for every joint but the first; a file of another skeleton shows here first. */
function checkColumns(
  weights: AttachParts,
  jointCount: number | undefined,
  diagnostics: Diagnostic[],
): AttachParts | undefined {
  if (jointCount === undefined || weights.columnCount === jointCount - 1) return weights;
  const log = new DiagnosticLog(weights.file);
  log.error({
    code: 'attach/field-count',
    line: 1,
    expected: `${jointCount - 1} weights (${jointCount} joints, less the root)`,
    found: `${weights.columnCount}`,
    effect: 'the mesh is shown without its weights',
  });
  diagnostics.push(...log.diagnostics);
  return undefined;
}

/** A file for each part that there is; a lone joint has no column of weights. */
function writeCharacter({ name, skeleton, mesh, skin }: Character): readonly OutputFile[] {
  const files: OutputFile[] = [];
  const hasWeights = skeleton.jointCount > 1 && !skin.paletteJoint.includes(noJoint);
  if (skeleton.jointCount > 0) files.push({ path: `${name}.skel`, bytes: writeSkel(skeleton) });
  if (mesh.pointCount > 0) {
    files.push({ path: `${name}.obj`, bytes: writeObj(mesh) });
    if (hasWeights) files.push({ path: `${name}.attach`, bytes: writeAttach(skin, skeleton) });
  }
  return files;
}
