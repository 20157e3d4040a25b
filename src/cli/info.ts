import { parseArgs } from 'node:util';
import { boneFrames } from '../core/bone-frames.ts';
import { boneWeights } from '../core/bone-weights.ts';
import type { Character } from '../core/character.ts';
import { printable } from '../core/diagnostics.ts';
import { jointMatrices } from '../core/forward-kinematics.ts';
import { axisDofs } from '../core/pose.ts';
import { DofKind, noParent, type Skeleton } from '../core/skeleton.ts';
import { largestInfluenceCount, type Skin } from '../core/skin.ts';
import { readCharacters } from '../formats/read-characters.ts';
import { writeFloat32 } from '../formats/text/write-number.ts';
import { rowCount } from '../skinning/weights/views.ts';
import type { Command } from './command.ts';
import { printDiagnostics, readFiles } from './files.ts';
import { parseWords } from './parse-words.ts';
import { UsageError } from './usage-error.ts';

/** `info FILES [--bones] [--json]` lists what is in the files. */
export const info: Command = {
  name: 'info',
  usage: 'info FILES [--bones] [--json]',
  summary:
    'Lists the joints, meshes, morphs and clips of each character in the files, and with --bones its bones.',
  async run(words) {
    const { values, positionals } = parseWords(() =>
      parseArgs({
        args: [...words],
        options: { json: { type: 'boolean' }, bones: { type: 'boolean' } },
        allowPositionals: true,
      }),
    );
    if (positionals.length === 0) throw new UsageError('expected files, found none');
    const { files, diagnostics: unreadable } = readFiles(positionals);
    const outcome = await readCharacters(files);
    const diagnostics = [...unreadable, ...outcome.diagnostics];
    const characters = outcome.characters.map(({ character }) => {
      return { ...describe(character), ...(values.bones ? describeBones(character) : {}) };
    });
    if (values.json) console.log(JSON.stringify({ characters, diagnostics }, null, 2));
    else characters.forEach((character) => console.log(summary(character)));
    printDiagnostics(diagnostics);
    return characters.length > 0 ? 0 : 1;
  },
};

/** Names come from files, so they are shortened and made printable before a terminal sees them. */
const longestName = 200;

type Description = ReturnType<typeof describe> & Partial<ReturnType<typeof describeBones>>;

function describe(character: Character) {
  const { name, skeleton, mesh, skin, bounds, missing, meta } = character;
  const characterFromJoint = jointMatrices(skeleton, skeleton.qRest);
  return {
    name,
    missing,
    fileSpace: meta.fileSpace,
    vertices: mesh.pointCount,
    triangles: mesh.indices.length / 3,
    largestInfluenceCount: largestInfluenceCount(skin),
    verticesOverFourInfluences: countOver(skin, 4),
    materials: character.materials,
    morphs: character.morphs.map((morph) => {
      return { name: morph.name, vertices: morph.parts.points.length };
    }),
    clips: character.clips.map(({ name: clip, start, end, channels }) => {
      return { name: clip, start, end, channels: channels.length };
    }),
    bounds: { min: [...bounds.min], max: [...bounds.max] },
    joints: Array.from(skeleton.jointOfSource, (joint, index) => {
      const parent = skeleton.parents[joint]!;
      return {
        index,
        name: skeleton.names[joint]!,
        parent: parent === noParent ? noParent : skeleton.sourceIndex[parent]!,
        offset: [...skeleton.restOffsets.subarray(joint * 3, joint * 3 + 3)],
        ...describeDofs(skeleton, joint),
        /** (4 × 4) column-major, in the file's pose. */
        worldFromJoint: [...characterFromJoint.subarray(joint * 16, joint * 16 + 16)],
      };
    }),
  };
}

/** How many points have more influences than that. */
function countOver(skin: Skin, most: number): number {
  let count = 0;
  for (let point = 0; point + 1 < skin.start.length; point++) {
    if (rowCount(skin, point) > most) count++;
  }
  return count;
}

/**
 * The bones that the Virtual Mannequin's handout defines. Joints are given by their index in the
 * file. T and R are 4 × 4 and column-major. `vertices` and `weights` are the bone's row of the
 * weights by bone.
 */
function describeBones({ skeleton, skin }: Character) {
  const frames = boneFrames(skeleton);
  const { start, points, weights } = boneWeights(frames, skin);
  return {
    bones: frames.map((frame, bone) => {
      const row = [start[bone]!, start[bone + 1]!] as const;
      return {
        source: skeleton.sourceIndex[frame.source]!,
        destination: skeleton.sourceIndex[frame.destination]!,
        /** Index in this list of the bone that ends at this bone's source. */
        parent: frame.parent,
        length: frame.length,
        T: [...frame.translation],
        R: [...frame.rotation],
        vertices: [...points.subarray(...row)],
        weights: [...weights.subarray(...row)],
      };
    }),
  };
}

/**
 * Rest angles and limits (radians) of a joint's hinges by axis x, y, z; null means no hinge or no
 * limit.
 */
function describeDofs(skeleton: Skeleton, joint: number) {
  const pose: (number | null)[] = [null, null, null];
  const limits: ([number | null, number | null] | null)[] = [null, null, null];
  const finite = (value: number): number | null => (Number.isFinite(value) ? value : null);
  for (const { kind, axis, index } of axisDofs(skeleton, joint)) {
    if (kind !== DofKind.hinge) continue;
    pose[axis] = skeleton.qRest[index]!;
    const range = [finite(skeleton.qMin[index]!), finite(skeleton.qMax[index]!)] as const;
    limits[axis] = range[0] === null && range[1] === null ? null : [...range];
  }
  const box = Array.from(skeleton.displayBoxes?.subarray(joint * 6, joint * 6 + 6) ?? [], (value) =>
    Number(writeFloat32(value)),
  );
  const corners = { min: box.slice(0, 3), max: box.slice(3) };
  return { pose, limits, ...(box.length > 0 ? { box: corners } : {}) };
}

function summary(character: Description): string {
  const { name, joints, vertices, triangles, largestInfluenceCount: influences } = character;
  const over = character.verticesOverFourInfluences;
  const some = over > 0 ? `, more than 4 at ${over} of the vertices` : '';
  const missing = character.missing.length > 0 ? `, without ${character.missing.join(', ')}` : '';
  return [
    `${printable(name, longestName)}: ${joints.length} joints, ${vertices} vertices, ${triangles} triangles, ` +
      `at most ${influences} influences${some}${missing}`,
    ...joints.map(
      ({ index, name: own, parent }) =>
        `  #${index} ${printable(own, longestName)} (parent ${parent})`,
    ),
    ...(character.bones ?? []).map(
      ({ source, destination, length, vertices: own }) =>
        `  bone #${source} to #${destination}: length ${writeFloat32(Math.fround(length))}, ${own.length} vertices`,
    ),
    ...character.morphs.map(
      (morph) => `  morph ${printable(morph.name, longestName)}: ${morph.vertices} vertices`,
    ),
    ...character.clips.map(
      (clip) =>
        `  clip ${printable(clip.name, longestName)}: ${clip.channels} channels, ${clip.start} to ${clip.end} s`,
    ),
  ].join('\n');
}
