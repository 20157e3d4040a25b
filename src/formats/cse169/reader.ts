import { buildMesh } from '../../core/build-mesh.ts';
import type { CharacterParts, MorphParts } from '../../core/character-parts.ts';
import type { ClipParts } from '../../core/motion/clip-parts.ts';
import { type Diagnostic, DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import type { Limits } from '../../core/limits.ts';
import { baseName, extensionOf } from '../file-entry.ts';
import type { FileEntry, FileGroup, FormatReader } from '../format.ts';
import { readAnim } from './anim.ts';
import type { SkinFile } from './assemble-skin.ts';
import { bindChannels } from './bind-channels.ts';
import { groupFiles } from './group-files.ts';
import { morphOffsets, readMorph } from './morph.ts';
import { readRig } from './rig.ts';
import { readSkel } from './skel.ts';
import { readSkin } from './skin.ts';

/**
 * UCSD CSE169: `balljoint` skeletons, skins, morph targets, clips, and rigs that name these files.
 */
export const cse169Reader: FormatReader = {
  group: groupFiles,
  read: readGroup,
};

async function readGroup(group: FileGroup, limits: Limits): Promise<Parsed<CharacterParts>> {
  const diagnostics: Diagnostic[] = [];
  const rigs = await readAll('.rig', readRig);
  const [skeleton] = await readAll('.skel', readSkel, 1);
  const [body] = await readAll('.skin', readSkin, 1);
  const skin = skeleton && body && skinThatFits(body, skeleton.file, skeleton.joints.length);
  const morphs = await readMorphs(body);
  const clips = await readClips(skeleton?.joints.length);
  if (!skeleton && !body) {
    if (!diagnostics.some(({ severity }) => severity === 'error')) diagnostics.push(alone(group));
    return { diagnostics };
  }
  const value: CharacterParts = {
    name: rigs[0]?.name !== undefined && rigs[0].name !== '' ? rigs[0].name : group.name,
    ...(skeleton ? { skeleton } : {}),
    ...(body ? { mesh: body.mesh } : {}),
    ...(skin ? { skin } : {}),
    morphs,
    clips,
    missing: ['.skel', '.skin'].filter((kind) => filesOf(group, kind).length === 0),
  };
  return { value, diagnostics };

  async function readAll<T>(
    kind: string,
    read: (file: string, bytes: Uint8Array, limits: Limits) => Parsed<T>,
    most = Infinity,
  ): Promise<T[]> {
    const values: T[] = [];
    for (const file of filesOf(group, kind).slice(0, most)) {
      const parsed = read(baseName(file.path), await file.bytes(), limits);
      diagnostics.push(...parsed.diagnostics);
      if (parsed.value !== undefined) values.push(parsed.value);
    }
    return values;
  }

  /**
   * Returns the skin if it has a binding for each joint; otherwise it belongs to another skeleton.
   */
  function skinThatFits({ skin: parts }: SkinFile, skeletonFile: string, jointCount: number) {
    const bindingCount = parts?.jointFromBind ? parts.jointFromBind.length / 16 : 0;
    if (!parts || bindingCount === jointCount) return parts;
    const log = new DiagnosticLog(parts.file);
    log.error({
      code: 'skin/count',
      expected: `${jointCount} bindings, one for each joint of ${skeletonFile}`,
      found: `${bindingCount}`,
      effect: 'the mesh is shown without its weights',
    });
    diagnostics.push(...log.diagnostics);
    return undefined;
  }

  async function readMorphs(skinFile: SkinFile | undefined): Promise<MorphParts[]> {
    const files = await readAll('.morph', readMorph);
    if (!skinFile || files.length === 0) return [];
    const { normals } = buildMesh(skinFile.mesh); // in this format each vertex has one normal
    return files.flatMap((file) => keep(morphOffsets(file, skinFile.mesh.positions, normals)));
  }

  async function readClips(jointCount: number | undefined): Promise<ClipParts[]> {
    const clips = await readAll('.anim', readAnim);
    return jointCount === undefined
      ? clips
      : clips.flatMap((clip) => keep(bindChannels(clip, jointCount)));
  }

  function keep<T>(parsed: Parsed<T>): T[] {
    diagnostics.push(...parsed.diagnostics);
    return parsed.value === undefined ? [] : [parsed.value];
  }
}

function filesOf(group: FileGroup, kind: string): FileEntry[] {
  return group.files.filter(({ path }) => extensionOf(path) === kind);
}

function alone(group: FileGroup): Diagnostic {
  const names = group.files.map(({ path }) => baseName(path));
  return {
    severity: 'warning',
    code: 'file/missing',
    file: names[0]!,
    expected: 'a .skel or a .skin with it',
    found: names.join(', '),
    effect: 'there is nothing to show',
  };
}
