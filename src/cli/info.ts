import { parseArgs } from 'node:util';
import type { Character } from '../core/character.ts';
import { printable } from '../core/diagnostics.ts';
import { worldMatrices } from '../core/forward-kinematics.ts';
import { noParent } from '../core/skeleton.ts';
import { largestInfluenceCount } from '../core/skin.ts';
import { readCharacters } from '../formats/read-characters.ts';
import type { Command } from './commands.ts';
import { printDiagnostics, readFiles } from './files.ts';
import { parseWords } from './parse-words.ts';
import { UsageError } from './usage-error.ts';

/** `info FILES [--json]`: what is in the files. */
export const info: Command = {
  name: 'info',
  usage: 'info FILES [--json]',
  async run(words) {
    const { values, positionals } = parseWords(() =>
      parseArgs({
        args: [...words],
        options: { json: { type: 'boolean' } },
        allowPositionals: true,
      }),
    );
    if (positionals.length === 0) throw new UsageError('expected files, found none');
    const { files, diagnostics: unreadable } = readFiles(positionals);
    const outcome = await readCharacters(files);
    const diagnostics = [...unreadable, ...outcome.diagnostics];
    const characters = outcome.characters.map(({ character }) => describe(character));
    if (values.json) console.log(JSON.stringify({ characters, diagnostics }, null, 2));
    else characters.forEach((character) => console.log(summary(character)));
    printDiagnostics(diagnostics);
    return characters.length > 0 ? 0 : 1;
  },
};

/** Names come from files, and may hold what a terminal acts on. */
const longestName = 200;

type Description = ReturnType<typeof describe>;

function describe({ name, skeleton, mesh, skin, bounds, missing }: Character) {
  const worldFromJoint = worldMatrices(skeleton, skeleton.qRest);
  return {
    name,
    missing,
    vertices: mesh.pointCount,
    triangles: mesh.indices.length / 3,
    largestInfluenceCount: largestInfluenceCount(skin),
    bounds: { min: [...bounds.min], max: [...bounds.max] },
    joints: Array.from(skeleton.jointOfSource, (joint, index) => {
      const parent = skeleton.parents[joint]!;
      return {
        index,
        name: skeleton.names[joint]!,
        parent: parent === noParent ? noParent : skeleton.sourceIndex[parent]!,
        offset: [...skeleton.restOffsets.subarray(joint * 3, joint * 3 + 3)],
        /** Column-major, at the file's pose. */
        worldFromJoint: [...worldFromJoint.subarray(joint * 16, joint * 16 + 16)],
      };
    }),
  };
}

function summary(character: Description): string {
  const { name, joints, vertices, triangles, largestInfluenceCount: influences } = character;
  const missing = character.missing.length > 0 ? `, without ${character.missing.join(', ')}` : '';
  return [
    `${printable(name, longestName)}: ${joints.length} joints, ${vertices} vertices, ${triangles} triangles, ` +
      `at most ${influences} influences${missing}`,
    ...joints.map(
      (joint) => `  #${joint.index} ${printable(joint.name, longestName)} (parent ${joint.parent})`,
    ),
  ].join('\n');
}
