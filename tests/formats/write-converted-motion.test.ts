import { describe, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { clipFor, evaluateClip } from '../../src/core/motion/clip.ts';
import type { ChannelParts, ClipParts } from '../../src/core/motion/clip-parts.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { convertCharacter } from '../../src/formats/convert.ts';
import { writeAnimOf } from '../../src/formats/cse169/anim-of-clip.ts';
import { writeSkel } from '../../src/formats/cse169/write-skel.ts';
import { writeMotion } from '../../src/formats/motion/write-motion.ts';
import { readBoundMotion } from '../../src/formats/motion/read-bound-motion.ts';
import type { ConvertTarget } from '../../src/formats/registry.ts';
import { writeMotionsBeside } from '../../src/formats/write-converted-motion.ts';
import { legSkel } from '../support/cse169-files.ts';
import { largestDifference } from '../support/compare.ts';
import { readOne } from '../support/files.ts';

const leg = await readOne({ 'a.skel': legSkel });
const key = (time: number, value: number) => {
  return { time, value, tangentIn: 'linear', tangentOut: 'linear' } as const;
};
const turn: ChannelParts = {
  target: { of: 'value', joint: 0, kind: DofKind.hinge, axis: 0 },
  before: 'constant',
  after: 'constant',
  keys: [key(0, 0), key(1, 0.5)],
};
const pin: ChannelParts = { ...turn, target: { of: 'pin', joint: 1, value: 'x' } };

function beside(to: ConvertTarget, ...channels: readonly ChannelParts[]) {
  const clip: ClipParts = { file: '', name: 'bend', start: 0, end: 1, fps: 30, channels };
  const converted = convertCharacter({ ...leg, clips: [] }, to, { q: leg.skeleton.qRest });
  const { files, losses } = writeMotionsBeside([clip], converted, to);
  return { converted, files, losses, paths: files.map(({ path }) => path) };
}

describe('motions of joints that the written files have in another order', () => {
  // The fourth joint hangs from the second one, and stands before the third in a nested file.
  const skel = '0 0 0 -1\n1 0 0 0\n-1 0 0 0\n0 1 0 1\n0 1 0 2\n';

  it.each(['anim', 'motion.json'])('move the same joints by their %s', async (ending) => {
    const branched = await readOne({ 'b.skel': skel });
    const channels = [1, 2, 3].map((joint) => ({
      target: { of: 'value', joint, kind: DofKind.hinge, axis: 0 } as const,
      before: 'constant' as const,
      after: 'constant' as const,
      keys: [key(0, joint / 4)],
    }));
    const clip: ClipParts = { file: '', name: 'bend', start: 0, end: 1, fps: 30, channels };
    const converted = convertCharacter(branched, 'cse169', { q: branched.skeleton.qRest });
    const { clip: moved } = converted.convertClip(clip);
    const { skeleton } = converted.character;
    const written =
      ending === 'anim'
        ? writeAnimOf(moved, skeleton, converted.pose.q)
        : writeMotion(moved, {
            ...converted.character,
            skeleton: { ...skeleton, names: skeleton.names.map(() => 'twin') },
          });
    const saved = await readOne({ 'b.skel': new TextDecoder().decode(writeSkel(skeleton)) });
    const { path, bytes } = written.files[0]!;
    const read = readBoundMotion(path, bytes, saved);
    expect(read.diagnostics).toEqual([]);
    const places = [placesOf(branched, clip), placesOf(saved, read.value!)];
    expect(largestDifference(places[1]!, places[0]!)).toBeLessThan(1e-9);
  });
});

/** (jointCount × 3) where the joints are at the start of a clip, depth first. */
function placesOf(character: Character, clip: ClipParts): number[] {
  const { skeleton } = character;
  const q = skeleton.qRest.slice();
  const values = {
    q,
    morphWeights: new Float64Array(0),
    pins: new Float64Array(skeleton.jointCount * 4),
  };
  evaluateClip(clipFor(clip, character), 0, values);
  const matrices = jointMatrices(skeleton, q);
  return [...skeleton.parents.keys()].flatMap((joint) => [
    ...matrices.subarray(joint * 16 + 12, joint * 16 + 15),
  ]);
}

describe('motions beside a character that is saved', () => {
  it('are an .anim alone where that holds all of it', () => {
    expect(beside('cse169', turn)).toMatchObject({ paths: ['bend.anim'], losses: [] });
  });

  it('are a MOTION.json too where the .anim loses something, which is said', () => {
    const { paths, losses } = beside('cse169', turn, pin);
    expect(paths).toEqual(['bend.anim', 'bend.motion.json']);
    expect(losses.length).toBeGreaterThan(0);
  });

  it('are a MOTION.json that the saved character reads where the format has no clips', () => {
    const { paths, files, losses, converted } = beside('mit', turn);
    expect(paths).toEqual(['bend.motion.json']);
    expect(losses.every(({ severity }) => severity !== 'error')).toBe(true);
    const read = readBoundMotion('bend.motion.json', files[0]!.bytes, converted.character);
    expect(read.diagnostics).toEqual([]);
    expect(read.value!.channels.length).toBeGreaterThan(0);
  });
});
