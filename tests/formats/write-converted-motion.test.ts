import { describe, expect, it } from 'vitest';
import type { ChannelParts, ClipParts } from '../../src/core/motion/clip-parts.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { convertCharacter } from '../../src/formats/convert.ts';
import { readBoundMotion } from '../../src/formats/motion/read-bound-motion.ts';
import type { ConvertTarget } from '../../src/formats/registry.ts';
import { writeMotionsBeside } from '../../src/formats/write-converted-motion.ts';
import { legSkel } from '../support/cse169-files.ts';
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
