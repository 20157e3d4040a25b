import { describe, expect, it } from 'vitest';
import { buildCharacter } from '../../../src/core/build-character.ts';
import type { Character } from '../../../src/core/character.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { restPose } from '../../../src/core/pose.ts';
import { writeMit } from '../../../src/formats/mit/write-character.ts';
import { linearBlend } from '../../../src/skinning/linear-blend.ts';
import { skinVertices } from '../../support/skin-vertices.ts';
import { characterOfRig, partsOfRig } from '../../fixtures/character-of-rig.ts';
import { allRigs, rotatedTree } from '../../fixtures/rigs.ts';
import { largestDifference } from '../../support/compare.ts';
import { courseSkel } from '../../support/course-skeleton.ts';
import { shown } from '../../support/diagnose.ts';
import { readOne } from '../../support/files.ts';
import { tolerances } from '../../tolerances.ts';

const files = {
  'a.skel': '0 0 0 -1\n0 1 0 0\n0 1 0 1\n',
  'a.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n',
  'a.attach': '1 0\n0.5 0.5\n0 0\n',
};

function losses(character: Character): string[] {
  return shown(writeMit(character).losses);
}

function loss(file: string, found: string, code: string, effect: string): string {
  return `warning: ${file}: expected what the format holds, found "${found}" [${code}/lost]; ${effect}`;
}

async function readAgain(character: Character): Promise<Character> {
  const written = writeMit(character).files.map(({ path, bytes }) => [path, bytes] as const);
  return readOne(Object.fromEntries(written));
}

describe('what writing to .skel, .obj and .attach loses', () => {
  it('is nothing for a character that these files can hold', async () => {
    expect(losses(await readOne(files))).toEqual([]);
    expect(losses(await readOne({ 'a.skel': courseSkel }))).toEqual([]);
  });

  it('is reported for each kind, with a count', () => {
    const turned = loss(
      'rig.skel',
      'rest rotations and poses of joints: 9',
      'skel',
      'joints keep their places; their axes are those of the world at rest',
    );
    const messages = losses(characterOfRig(rotatedTree()));
    expect(messages).toHaveLength(4);
    expect(messages[0]).toBe(turned);
    expect(messages[1]).toContain('found "degrees of freedom of joints: 7"');
    expect(messages[2]).toContain('found "names of joints: 9"');
    expect(messages[3]).toMatch(/found "weights on joint 0, for vertices: \d+"/);
  });

  it('includes the limits of joints', () => {
    const parts = partsOfRig(rotatedTree());
    const joints = parts.skeleton!.joints.map((joint, index) => ({
      ...joint,
      dofs: joint.dofs.map((dof) => (index === 0 ? { ...dof, limits: [-1, 1] as const } : dof)),
    }));
    const character = buildCharacter({ ...parts, skeleton: { file: 'a', joints } }).value!;
    expect(losses(character)).toContain(
      loss('rig.skel', 'limits of joints: 1', 'skel', 'joints turn without limits'),
    );
  });

  it('includes the weights of the first joint, unless it alone has a vertex', async () => {
    const character = await readOne(files);
    const { skin } = character;
    // The third row follows only the root; here the second one does too.
    const entries = skin.entries.with(1, 0);
    expect(losses({ ...character, skin: { ...skin, entries } })).toEqual([
      loss(
        'a.attach',
        'weights on joint 0, for vertices: 1',
        'attach',
        'they are left out, as the format has no column for them',
      ),
    ]);
  });

  it('includes binds that differ from the rest pose', () => {
    const messages = losses(characterOfRig(allRigs['own binds']!()));
    expect(messages.at(-1)).toContain('found "binds of joints: 9" [attach/lost]');
  });

  it('includes line ends in the name of a material', async () => {
    const character = await readOne(files);
    const [submesh] = character.mesh.submeshes;
    const named = (material: string): Character => ({
      ...character,
      mesh: { ...character.mesh, submeshes: [{ ...submesh!, material }] },
    });
    const effect = 'they are written without line ends, and without blanks and \\ at their ends';
    for (const material of ['a\nf 1 1 1', ' a ', 'a\\', 'a\r', '\0']) {
      expect(losses(named(material))).toEqual([
        loss('a.obj', 'names of materials: 1', 'obj', effect),
      ]);
      expect((await readAgain(named(material))).mesh.indices).toEqual(character.mesh.indices);
    }
    expect((await readAgain(named('a\nf 1 1 1\\'))).mesh.submeshes[0]?.material).toBe('a f 1 1 1');
  });
});

describe('approximations in written files', () => {
  it('keep joints and vertices in place at rest, even if joints are rotated', async () => {
    const character = characterOfRig(rotatedTree());
    const again = await readAgain(character);
    const places = ({ skeleton }: Character): number[] => {
      const world = jointMatrices(skeleton, skeleton.qRest);
      return Array.from(skeleton.jointOfSource, (joint) => [
        ...world.subarray(joint * 16 + 12, joint * 16 + 15),
      ]).flat();
    };
    expect(largestDifference(places(again), places(character))).toBeLessThan(
      tolerances.kinematics * 10,
    );
    const { positions } = skinVertices(again, again.skin, restPose(again.skeleton), linearBlend);
    expect(positions).toHaveLength(character.mesh.positions.length);
  });

  it('bind a single joint by blank rows', async () => {
    const lone = { ...files, 'a.skel': '1 2 3 -1\n', 'a.attach': '\n\n\n' };
    const character = await readOne(lone);
    expect([...character.skin.paletteJoint]).toEqual([0]);
    expect(character.skin.weights).toEqual(Float32Array.of(1, 1, 1));
    expect(losses(character)).toEqual([]);
    expect(await readAgain(character)).toEqual(character);
  });
});
