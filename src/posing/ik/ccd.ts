import { DofKind } from '../../core/skeleton.ts';
import { AxisTurn } from './axis-turn.ts';
import { type Move, type Sweeper, naturalSweeps } from './sweeps.ts';

const turn = new AxisTurn();

/**
 * Cyclic coordinate descent (Wang and Chen 1991): from the tip to the root, each degree of freedom
 * takes the value that brings the goals' points nearest to their targets while the others rest. With
 * several goals that is the least weighted sum of squares, so that no goal is favored by its order.
 */
export const ccd = naturalSweeps(function* sweep(sweeper: Sweeper): Generator<Move> {
  for (let column = sweeper.space.columnCount - 1; column >= 0; column--) {
    const moved = sweeper.move(column, bestMove(sweeper, column));
    if (moved !== 0) yield { column, moved };
  }
});

function bestMove({ kinematics, space, chains, problem }: Sweeper, column: number): number {
  const { axes, origins, points, columnsOf } = kinematics;
  const isSlide = space.kinds[column] === DofKind.slide;
  const at = column * 3;
  turn.clear();
  let [along, weights] = [0, 0];
  for (let goal = 0; goal < columnsOf.length; goal++) {
    if (!columnsOf[goal]!.includes(column)) continue;
    const { target, weight } = problem.goals[goal]!;
    const scaled = (weight / chains[goal]!.length) ** 2;
    if (isSlide) {
      weights += scaled;
      for (let row = 0; row < 3; row++)
        along += scaled * axes[at + row]! * (target[row]! - points[goal * 3 + row]!);
    } else turn.add(axes, origins, at, points, goal * 3, target, scaled);
  }
  if (isSlide) return weights === 0 ? 0 : along / weights;
  return turn.angle;
}
