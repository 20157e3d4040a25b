import { mat4 } from 'gl-matrix';
import { beforeAll, expect, it } from 'vitest';
import { boneFrames, placeBones } from '../../src/core/bone-frames.ts';
import { buildSkeleton } from '../../src/core/build-skeleton.ts';
import type { Character } from '../../src/core/character.ts';
import { DiagnosticLog } from '../../src/core/diagnostics.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import type { Pose } from '../../src/core/pose.ts';
import { computeVertexNormals } from '../../src/core/vertex-normals.ts';
import type { OutputFile } from '../../src/formats/format.ts';
import { mmdOf } from '../../src/formats/mmd/mmd-parts.ts';
import { writeMmd } from '../../src/formats/mmd/write-character.ts';
import { poseFromJson } from '../../src/formats/pose-json.ts';
import { noPins } from '../../src/posing/pins/pin.ts';
import { plainNatures } from '../../src/posing/natural/nature-settings.ts';
import { applyRotationLinks } from '../../src/posing/rotation-links.ts';
import { largestBindError } from '../../src/skinning/bind-error.ts';
import { linearBlend } from '../../src/skinning/linear-blend.ts';
import { skinVertices } from '../support/skin-vertices.ts';
import { expectSound } from '../support/check-character.ts';
import { largestDifference } from '../support/compare.ts';
import { readContents } from '../support/files.ts';
import { tolerances } from '../tolerances.ts';
import { describeWithShared, sharedBytes, sharedFloats, sharedJson } from './shared-material.ts';
import { layerInput } from '../support/layer-input.ts';

interface Kaito {
  readonly vertices: number;
  readonly triangles: number;
  readonly bones: readonly string[];
  readonly parents: readonly number[];
  readonly bone_positions: readonly (readonly number[])[];
  readonly poses: readonly {
    readonly angles_xyz: readonly (readonly number[])[];
    readonly root_translation?: readonly number[];
  }[];
}

const data = 'data/pmd/KAITO.pmd';
const reference = 'reference/pmd';

/** Converts x y z between the file's left-handed space and Sinew's. */
function mirrored(positions: ArrayLike<number>): Float64Array {
  return Float64Array.from(positions, (value, i) => (i % 3 === 2 ? -value : value));
}

describeWithShared('KAITO of the Virtual Mannequin', [data, `${reference}/KAITO.json`], () => {
  let character: Character;
  let expected: Kaito;

  beforeAll(async () => {
    const { characters, diagnostics } = await readContents({
      'KAITO.pmd': sharedBytes(data),
      'textures/EYEKT.BMP': new Uint8Array(1),
    });
    expect(diagnostics.map(({ effect }) => effect)).toEqual([
      'textures/EYEKT.BMP is used, by name',
    ]);
    character = characters[0]!.character;
    expect(characters[0]!.files.map(({ path }) => path)).toContain('textures/EYEKT.BMP');
    expected = sharedJson(`${reference}/KAITO.json`) as Kaito;
  });

  it('moves both eyes by 両目, where it is shown', () => {
    const { skeleton } = character;
    const ballOf = (name: string): number =>
      skeleton.dofQ[skeleton.dofStart[skeleton.names.indexOf(name) + 1]! - 1]!;
    const q = skeleton.qRest.slice();
    const turn = [0, Math.sin(0.1), 0, Math.cos(0.1)];
    q.set(turn, ballOf('両目'));
    const use = { character, clip: null, pins: noPins, natures: plainNatures };
    applyRotationLinks(...layerInput(use, q));
    for (const eye of ['左目', '右目']) {
      const at = ballOf(eye);
      turn.forEach((value, i) => expect(q[at + i]).toBeCloseTo(value, 12));
    }
  });

  function poseOf(which: number): Pose {
    const pose = expected.poses[which]!;
    const joints = pose.angles_xyz.map(([x, y, z], index) => [`#${index}`, [-x!, -y!, z]]);
    const [x, y, z] = pose.root_translation ?? [0, 0, 0];
    const json = { joints: Object.fromEntries(joints) as object, root: [x, y, -z!] };
    const { value, diagnostics } = poseFromJson('pose', json, character.skeleton);
    expect(diagnostics).toEqual([]);
    return value!;
  }

  it('is read whole: vertices, triangles, and the bones with all three roots', () => {
    expectSound(character);
    const { skeleton, mesh, materials, morphs } = character;
    const mmd = mmdOf(character);
    expect(mesh.pointCount).toBe(expected.vertices);
    expect(mesh.vertexCount).toBe(expected.vertices);
    expect(mesh.indices).toHaveLength(expected.triangles * 3);
    const joints = [...skeleton.jointOfSource];
    expect(joints.map((joint) => skeleton.fileNames[joint])).toEqual(expected.bones);
    const parents = joints.map((joint) => {
      const parent = skeleton.parents[joint]!;
      return parent === -1 ? -1 : skeleton.sourceIndex[parent]!;
    });
    expect(parents).toEqual(expected.parents);
    expect(parents.filter((parent) => parent === -1)).toHaveLength(3);
    expect(materials).toHaveLength(15);
    expect(morphs).toHaveLength(24);
    expect(mmd!.ikChains).toHaveLength(6);
    expect(mmd!.display.groupNames).toHaveLength(7);
    expect(mmd!.english!.boneNames).toHaveLength(106);
    expect(mmd!.toons[9]).toBe('toon10.bmp');
    expect(mmd!.physics).toBeUndefined();
    // The base morph equals the mesh at rest.
    mmd!.morphs.basePoints.forEach((point, index) => {
      const position = mesh.positions.subarray(point * 3, point * 3 + 3);
      expect(mmd!.morphs.basePositions.subarray(index * 3, index * 3 + 3)).toEqual(position);
    });
  });

  it('has its joints where the reference has them, and faces that look outwards', () => {
    const { skeleton, skin, mesh } = character;
    const world = jointMatrices(skeleton, skeleton.qRest);
    expected.bone_positions.forEach((position, source) => {
      const at = skeleton.jointOfSource[source]! * 16 + 12;
      expect(largestDifference(world.slice(at, at + 3), mirrored(position))).toBeLessThan(1e-5);
    });
    expect(largestBindError(skeleton, skin)).toBeLessThan(tolerances.bindError);
    const computed = new Float32Array(mesh.positions.length);
    computeVertexNormals(mesh.positions, mesh.indices, computed);
    const along = Array.from({ length: mesh.pointCount }, (_, point) =>
      [0, 1, 2].reduce((sum, i) => {
        return sum + computed[point * 3 + i]! * mesh.normals[point * 3 + i]!;
      }, 0),
    );
    expect(along.filter((cosine) => cosine > 0).length).toBeGreaterThan(0.98 * mesh.pointCount);
  });

  it('is equal in every section when it is written and read again', async () => {
    const { files, losses } = writeMmd(character);
    expect(losses).toEqual([]);
    const [{ bytes }] = files as [OutputFile];
    const { characters } = await readContents({
      'KAITO.pmd': bytes,
      'textures/EYEKT.BMP': new Uint8Array(1),
    });
    expect(characters[0]!.character).toEqual(character);
    expect(writeMmd(characters[0]!.character).files[0]!.bytes).toEqual(bytes);
    // Of the bytes, only the signs of some zeros change, and what pads a field behind its text.
    const original = sharedBytes(data);
    expect(bytes).toHaveLength(original.length);
    const changes = Array.from(bytes).flatMap((byte, i) => {
      return byte === original[i] ? [] : [`${original[i]!} to ${byte}`];
    });
    expect([...new Set(changes)]).toEqual(['128 to 0', '0 to 253']);
    expect(changes.filter((change) => change === '128 to 0')).toHaveLength(27);
  });

  it('can be written as if it came from another course, with the same vertices', async () => {
    const { extra, ...foreign } = character;
    expect(extra).toBeDefined();
    const { files, losses } = writeMmd(foreign);
    expect(losses).toEqual([]);
    const again = (await readContents({ 'a.pmd': files[0]!.bytes })).characters[0]!.character;
    const posed = [again, character].map((each) => {
      return skinVertices(each, each.skin, poseOf(0), linearBlend).positions;
    });
    expect(largestDifference(posed[0]!, posed[1]!)).toBeLessThan(tolerances.mannequinFiles);
    expect(again.skeleton.fileNames).toEqual(character.skeleton.fileNames);
    expect(again.materials.map(({ colors }) => colors)).toEqual(
      character.materials.map(({ colors }) => colors),
    );
    expect(again.morphs.map(({ vertices, offsets }) => [vertices, offsets])).toEqual(
      character.morphs.map(({ vertices, offsets }) => [vertices, offsets]),
    );
  });

  it.each([0, 1])('has every vertex where the reference has it: pose %i', (which) => {
    const { positions } = skinVertices(character, character.skin, poseOf(which), linearBlend);
    const wanted = sharedFloats(`${reference}/KAITO.pose${which}.lbs.f32`);
    expect(wanted).toHaveLength(expected.vertices * 3);
    const error = largestDifference(mirrored(positions), wanted);
    expect(error).toBeLessThan(tolerances.mannequinFiles);
  });
});

interface Frames {
  readonly joints: readonly (readonly [number, number, number])[];
  readonly joint_parents: readonly number[];
  readonly bones: readonly {
    readonly joints: readonly [number, number];
    readonly parent_bone: number;
    readonly length: number;
    readonly T_translation: readonly number[];
    readonly R_local: readonly number[];
    readonly world_tnb_columns: readonly number[];
    readonly origin: readonly number[];
    readonly end: readonly number[];
  }[];
  readonly posed: {
    readonly bones: readonly {
      readonly origin: readonly number[];
      readonly end: readonly number[];
      readonly tnb_columns: readonly number[];
    }[];
  };
}

/** The nine numbers of a rotation, row by row. */
function rows(matrix: ArrayLike<number>): number[] {
  return [0, 1, 2].flatMap((row) => [0, 1, 2].map((column) => matrix[column * 4 + row]!));
}

describeWithShared('bone frames of the Virtual Mannequin', ['reference/pmd_frames.json'], () => {
  const bound = tolerances.boneFrames;

  function read() {
    const expected = sharedJson('reference/pmd_frames.json') as Frames;
    const joints = expected.joints.map(([x, y, z], index) => {
      const parent = expected.joint_parents[index]!;
      const [px, py, pz] = expected.joints[parent] ?? [0, 0, 0];
      const restOffset = [x - px, y - py, z - pz] as const;
      return { name: `${index}`, parent, restOffset, dofs: [] };
    });
    const skeleton = buildSkeleton({ file: 'a', joints }, new DiagnosticLog('a'))!;
    return { expected, skeleton, frames: boneFrames(skeleton) };
  }

  it('are equal at rest', () => {
    const { expected, skeleton, frames } = read();
    expect(frames).toHaveLength(expected.bones.length);
    const placed = placeBones(frames);
    expected.bones.forEach((wanted, bone) => {
      const frame = frames[bone]!;
      const ends = [frame.source, frame.destination].map((joint) => skeleton.sourceIndex[joint]);
      expect(ends).toEqual(wanted.joints);
      expect(frame.parent).toBe(wanted.parent_bone);
      expect(Math.abs(frame.length - wanted.length)).toBeLessThan(bound);
      const T = Array.from(frame.translation).slice(12, 15);
      expect(largestDifference(T, wanted.T_translation)).toBeLessThan(bound);
      expect(largestDifference(rows(frame.rotation), wanted.R_local.flat())).toBeLessThan(bound);
      const axes = wanted.world_tnb_columns.flat();
      expect(largestDifference(rows(frame.axes), axes)).toBeLessThan(bound);
      expect(largestDifference(rows(placed[bone]!.axes), axes)).toBeLessThan(bound);
      expect(largestDifference(placed[bone]!.origin, wanted.origin)).toBeLessThan(bound);
      expect(largestDifference(placed[bone]!.end, wanted.end)).toBeLessThan(bound);
    });
  });

  it('are equal with S in place of R', () => {
    const { expected, frames } = read();
    const turned = (bone: number, angle: number, axis: [number, number, number]): mat4 =>
      mat4.rotate(new Float64Array(16), frames[bone]!.rotation, angle, axis);
    // Rotates the bone from joint 1 to joint 2 by 40° about its b, and the one from 2 to 5 by 30°
    // about its t.
    const rotations = frames.map(({ rotation }) => rotation);
    rotations[1] = turned(1, (40 * Math.PI) / 180, [0, 0, 1]);
    rotations[4] = turned(4, (30 * Math.PI) / 180, [1, 0, 0]);
    const placed = placeBones(frames, rotations);
    expected.posed.bones.forEach(({ origin, end, tnb_columns: axes }, bone) => {
      expect(largestDifference(placed[bone]!.origin, origin)).toBeLessThan(bound);
      expect(largestDifference(placed[bone]!.end, end)).toBeLessThan(bound);
      expect(largestDifference(rows(placed[bone]!.axes), axes.flat())).toBeLessThan(bound);
    });
  });
});
