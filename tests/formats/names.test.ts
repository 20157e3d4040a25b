import { describe, expect, it } from 'vitest';
import { buildSkeleton } from '../../src/core/build-skeleton.ts';
import { DiagnosticLog, formatDiagnostic } from '../../src/core/diagnostics.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { poseToJson } from '../../src/formats/write-pose-json.ts';
import { readPoseJson } from '../../src/formats/read-pose-json.ts';
import { readContents } from '../support/files.ts';
import { zipOf } from '../support/zip.ts';

const obj = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';

const names: Readonly<Record<string, string>> = {
  'of a prototype': '__proto__',
  'of its constructor': 'constructor',
  'with markup': '<img src=x onerror=alert(1)>',
  'with controls and bidi marks': 'a\u001b[2J\u202egnp\u2066',
  'of 10,000 characters': '骨'.repeat(10_000),
  'of other scripts': 'Müller 模型 🦴',
  'with points': 'a.b.c',
  'with quotes': `"'\`\${x}`,
};

describe.each(Object.entries(names))('a name %s', (_, name) => {
  it('is the name of its character, unchanged, alone and in an archive', async () => {
    for (const contents of [
      { [`x/${name}.obj`]: obj },
      { [`${name}.OBJ`]: obj },
      { 'a.zip': zipOf({ [`x\\${name}.obj`]: obj }) },
    ]) {
      const { characters, diagnostics } = await readContents(contents);
      expect(characters.map(({ character }) => character.name)).toEqual([name]);
      expect(diagnostics).toEqual([]);
    }
  });

  it('affects neither page nor terminal in a message, and is shortened there', async () => {
    const contents = [
      { [`${name}.obj`]: 'f' },
      { [`${name}.txt`]: '' },
      { [`${name}.skel`]: '0 0 0 -1', 'b.obj': obj },
      { 'b.obj': `${obj}${name.replace(/\s/g, '')} 1\nmtllib ${name}\n` },
      { 'a.zip': zipOf({ [`${name}.zip`]: '' }) },
    ];
    for (const files of contents) {
      const { diagnostics } = await readContents(files);
      expect(diagnostics.length).toBeGreaterThan(0);
      for (const diagnostic of diagnostics) {
        const message = formatDiagnostic(diagnostic);
        expect(message).not.toMatch(/[\p{Cc}\p{Cf}]/u);
        expect(message.length).toBeLessThan(600);
        expect(diagnostic.effect).not.toMatch(/[\p{Cc}\p{Cf}]/u);
        expect(diagnostic.effect.length).toBeLessThan(200);
      }
    }
  });

  it('is read as a material, and ignored as a group or object', async () => {
    const text = `o ${name}\ng ${name}\n${obj.replace('f', `usemtl ${name}\nf`)}`;
    const { characters, diagnostics } = await readContents({ 'a.obj': text });
    expect(diagnostics).toEqual([]);
    const { mesh } = characters[0]!.character;
    expect(mesh.submeshes).toEqual([{ material: name, firstIndex: 0, indexCount: 3 }]);
  });

  it('is found as a joint of a pose, and reported if there is no such joint', () => {
    const axis = [1, 0, 0] as const;
    const dofs = [{ kind: DofKind.hinge, axis }];
    const joint = { name, parent: -1, restOffset: [0, 0, 0] as const, dofs };
    const log = new DiagnosticLog('a');
    const skeleton = buildSkeleton({ file: 'a', joints: [joint] }, log)!;
    // Parsed from text, because an object literal would set its prototype.
    const text = `{"joints": {${JSON.stringify(name)}: [2, 0, 0]}}`;
    const { value } = readPoseJson('p.json', text, skeleton);
    expect([...value!.q]).toEqual([2]);
    const again = JSON.stringify(poseToJson(skeleton, value!));
    expect(readPoseJson('p.json', again, skeleton).value).toEqual(value);
    const other = buildSkeleton({ file: 'a', joints: [{ ...joint, name: 'other' }] }, log)!;
    const { diagnostics } = readPoseJson('p.json', text, other);
    expect(diagnostics).toMatchObject([{ code: 'pose/unknown-joint' }]);
    expect(formatDiagnostic(diagnostics[0]!)).not.toMatch(/[\p{Cc}\p{Cf}]/u);
  });
});
