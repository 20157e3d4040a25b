import { courseBody, courseFiles } from '../data/course-files.ts';
import { type BenchOptions, type GroupResult, timesFaster, type Value } from '../harness/group.ts';
import { type Contender, contenderOf, measure } from '../harness/measure.ts';
import { loadPeer } from '../harness/load-peer.ts';
import { checkPeerResult, checkReadFile } from '../readers/check.ts';
import { readerKinds, type ReaderKind, sinewReaders } from '../readers/sinew.ts';

export type PeerReaders = Readonly<Record<ReaderKind, (bytes: Uint8Array) => unknown>>;

/** Readers of the courses' files against what people would pick instead. */
export async function readers({ rounds }: BenchOptions): Promise<GroupResult> {
  const { peerReaders } = await loadPeer<{ peerReaders: PeerReaders }>('readers');
  const contenders: Contender[] = [];
  const counts: Record<string, number> = {};
  for (const kind of readerKinds) {
    const body = courseBody(kind);
    const bytes = courseFiles[kind](body);
    checkReadFile(kind, await sinewReaders[kind](bytes), body);
    checkPeerResult(kind, peerReaders[kind](bytes), body);
    counts[`bytes of the .${kind}`] = bytes.length;
    contenders.push(
      contenderOf(`sinew ${kind}`, () => sinewReaders[kind](bytes)),
      contenderOf(`peer ${kind}`, () => peerReaders[kind](bytes)),
    );
  }
  const samples = await measure(contenders, rounds);
  const values = Object.fromEntries(
    readerKinds.map((kind): [string, Value] => [
      kind,
      timesFaster(samples, `sinew ${kind}`, `peer ${kind}`),
    ]),
  );
  return { samples, values, counts };
}
