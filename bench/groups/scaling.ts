import type { CDPSession, Page } from '@playwright/test';
import { createActor } from '../../src/document/scene.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { characterOf } from '../data/character.ts';
import { cylinder, poseAngles } from '../data/cylinder.ts';
import { frameContender, openPage } from '../frames/contender.ts';
import { launchBrowser } from '../harness/browser.ts';
import { buildPages } from '../harness/build-pages.ts';
import type { Curve, GroupResult } from '../harness/group.ts';
import { type Contender, contenderOf, measure, type Samples } from '../harness/measure.ts';
import { serve } from '../harness/serve.ts';
import { leastWall } from '../harness/statistics.ts';

/** The frames of a million vertices take seconds without a GPU. */
const rounds = 5;

interface Size {
  readonly vertices: number;
  readonly joints: number;
  readonly actors: number;
}

const usual: Size = { vertices: 10_000, joints: 18, actors: 1 };

/** What is varied, and the size of everything else. */
const axes: Readonly<Record<keyof Size, { counts: readonly number[]; fixed: Size }>> = {
  vertices: { counts: [1000, 10_000, 100_000, 1_000_000], fixed: usual },
  joints: { counts: [10, 30, 100, 300, 1000], fixed: usual },
  actors: { counts: [1, 3, 10, 30, 100], fixed: { ...usual, vertices: 1000 } },
};

const works = ['evaluation on the CPU', 'posed frame without a GPU'] as const;

/** How the cost of a pose grows with vertices, joints and actors. */
export async function scaling(): Promise<GroupResult> {
  const server = await serve(await buildPages('scaling', { sinew: 'frames/sinew.ts' }));
  const browser = await launchBrowser();
  try {
    const clock = await browser.newBrowserCDPSession();
    const open = (size: Size): Promise<Page> => {
      const { vertices, joints, actors } = size;
      const words = `vertices=${vertices}&joints=${joints}&actors=${actors}`;
      return openPage(browser, `${server.address}/sinew.page?${words}`);
    };
    let samples: Samples = {};
    for (const [axis, { counts, fixed }] of Object.entries(axes)) {
      for (const count of counts) {
        const size = { ...fixed, [axis]: count };
        samples = { ...samples, ...(await measureSize(`${count} ${axis}`, size, open, clock)) };
      }
    }
    return { values: {}, samples, counts: {}, curves: curvesOf(samples) };
  } finally {
    await browser.close();
    server.close();
  }
}

async function measureSize(
  id: string,
  size: Size,
  open: (size: Size) => Promise<Page>,
  clock: CDPSession,
): Promise<Samples> {
  const page = await open(size);
  const contenders: Contender[] = [
    contenderOf(`${works[0]}, ${id}`, evaluationOf(size)),
    frameContender(`${works[1]}, ${id}`, page, 'posed', clock),
  ];
  const samples = await measure(contenders, rounds);
  await page.close();
  return samples;
}

/** Poses actors in their own ways: joints, palettes, positions and normals. */
function evaluationOf({ vertices, joints, actors }: Size): (pose: number) => void {
  const character = characterOf(cylinder({ vertexCount: vertices, jointCount: joints }));
  const evaluators = Array.from({ length: actors }, (_, i) => {
    const actor = createActor(i + 1, character, 'linear-blend');
    return { actor, evaluator: new Evaluator(actor) };
  });
  return (pose) => {
    evaluators.forEach(({ actor, evaluator }, i) => {
      const q = poseAngles(joints, pose + 0.6 * i);
      evaluator.evaluate({ ...actor, q }, 0).vertices();
    });
  };
}

function curvesOf(samples: Samples): Curve[] {
  return Object.entries(axes).flatMap(([axis, { counts }]) =>
    works.map((what) => ({
      axis,
      what,
      points: counts.map((count) => {
        return [count, leastWall(samples[`${what}, ${count} ${axis}`]!)] as const;
      }),
    })),
  );
}
