import { expect, it } from 'vitest';
import { readIkProblems } from '../../src/cli/ik-problem-json.ts';
import { goalChains } from '../../src/posing/ik/goal-chains.ts';
import { ikMethods } from '../../src/posing/ik/methods.ts';
import { tolerances } from '../tolerances.ts';
import { describeWithShared, sharedBytes } from './shared-material.ts';

interface Reference {
  readonly problems: readonly {
    readonly name: string;
    readonly best_residual_per_effector: readonly number[];
  }[];
}

const path = 'reference/ik.json';

describeWithShared('the reference problems of inverse kinematics', [path], () => {
  const text = new TextDecoder().decode(sharedBytes(path));
  const { problems } = JSON.parse(text) as Reference;
  const read = readIkProblems('ik.json', text).value!.problems;

  it.each(ikMethods.map((method) => [method.id, method] as const))(
    'are solved as well as the best known, within the limits: %s',
    async (_, method) => {
      const solver = await method.load();
      expect(read).toHaveLength(problems.length);
      read.forEach(({ problem, name }, index) => {
        const { q, residuals } = solver.solve(problem);
        const chains = goalChains(problem);
        problems[index]!.best_residual_per_effector.forEach((best, goal) => {
          const most = best + tolerances.reached * chains[goal]!.length;
          expect(residuals[goal], name!).toBeLessThanOrEqual(most);
        });
        q.forEach((value, i) => {
          expect(value).toBeGreaterThanOrEqual(problem.skeleton.qMin[i]!);
          expect(value).toBeLessThanOrEqual(problem.skeleton.qMax[i]!);
        });
      });
    },
  );
});
