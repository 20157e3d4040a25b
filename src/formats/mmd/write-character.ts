import type { Character } from '../../core/character.ts';
import { DiagnosticLog } from '../../core/diagnostics.ts';
import { BinaryWriter } from '../binary/binary-writer.ts';
import type { Written } from '../format.ts';
import { bonePairs } from './bone-pairs.ts';
import { fittedText } from './encode-name.ts';
import { fittedNames } from './fitted-names.ts';
import { joined, materialRuns } from './material-runs.ts';
import type { MmdParts } from './mmd-parts.ts';
import { ownParts, partsOf } from './parts-of.ts';
import { writeBones } from './write-bones.ts';
import { writeDisplay } from './write-display.ts';
import { writeEnglish } from './write-english.ts';
import { writeFaces } from './write-faces.ts';
import { writeHeader } from './write-header.ts';
import { writeIkChains } from './write-ik.ts';
import { reportForeignParts, reportMaterials, reportNames } from './write-losses.ts';
import { writeMaterials } from './write-materials.ts';
import { writeMorphs } from './write-morphs.ts';
import { writePhysics } from './write-physics.ts';
import { writeToons } from './write-toons.ts';
import { writeVertices } from './write-vertices.ts';

/** Triangles refer to vertices by 16 bits, and programs keep the last number for none. */
const mostVertices = 65_535;

/**
 * Writes a PMD, left-handed, in the pose at rest. A character that was read from a PMD is written
 * with all the data of that file. Any other must turn by balls and have at most two influences a
 * vertex; `convertCharacter` converts it. A mesh with more vertices than the file can number is an
 * error, and there is no file.
 */
export function writeMmd(character: Character): Written {
  const path = `${character.name}.pmd`;
  const log = new DiagnosticLog(path);
  const { vertexCount } = character.mesh;
  if (vertexCount > mostVertices) {
    const expected = `at most ${mostVertices} vertices, as many as its triangles can number`;
    const effect = 'nothing is written';
    log.error({ code: 'pmd/limit', expected, found: `${vertexCount}`, effect });
    return { files: [], losses: log.diagnostics };
  }
  const bytes = writePmd(character, log);
  return { files: [{ path, bytes }], losses: log.diagnostics };
}

function writePmd(character: Character, log: DiagnosticLog): Uint8Array {
  const { skeleton, mesh, morphs } = character;
  const own = ownParts(character);
  const parts = own ?? foreignParts(character, log);
  const runs = materialRuns(character);
  const jointNames = own ? skeleton.fileNames : skeleton.names;
  const boneNames = Array.from(skeleton.jointOfSource, (joint) => jointNames[joint]!);
  const morphNames = parts.morphs.listed.map(({ fileName }) => fileName);
  const written = {
    model: fittedText(parts.modelName, 20),
    bones: fittedNames(boneNames, 20),
    morphs: fittedNames(morphNames, 20),
  };
  reportMaterials(runs, log);
  reportNames(
    [parts.modelName, ...boneNames, ...morphNames],
    [written.model, ...written.bones, ...written.morphs],
    log,
  );
  const out = new BinaryWriter();
  writeHeader(out, parts);
  writeVertices(out, mesh.positions, parts.vertices);
  writeFaces(out, joined(runs.map(({ corners }) => corners)));
  writeMaterials(out, runs);
  writeBones(out, written.bones, skeleton, parts.bones);
  writeIkChains(out, parts.ikChains);
  writeMorphs(out, written.morphs, parts.morphs, morphs);
  writeDisplay(out, parts.display);
  writeLastSections(out, parts);
  return out.done();
}

function foreignParts(character: Character, log: DiagnosticLog): MmdParts {
  const pairs = bonePairs(character);
  reportForeignParts(character, pairs, log);
  return partsOf(character, pairs);
}

/** The last sections may be missing, each with all that follow it. */
function writeLastSections(out: BinaryWriter, { english, toons, physics }: MmdParts): void {
  const hasToons = toons.length > 0;
  if (english || hasToons) writeEnglish(out, english);
  if (hasToons) writeToons(out, toons);
  if (physics) writePhysics(out, physics);
}
