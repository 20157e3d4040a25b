import { useEffect, useState } from 'preact/hooks';
import type { KernelId } from '../../../skinning/method.ts';
import type { Compared } from '../../deform-lab/compared.ts';
import { measureTimes, type MethodTimes } from '../../../view/measure-times.ts';
import { attempt } from '../../attempt.ts';
import type { Looking, Telling } from '../../editor.ts';

/** The page is to be quiet for so long before times are measured, in milliseconds. */
const quietTime = 500;

/** The times of the methods, which are measured once the methods and the character stay the same. */
export function useTimes(
  { viewer, evaluations, session, notice }: Looking & Telling,
  { rows }: Compared,
): ReadonlyMap<KernelId, MethodTimes> {
  const [times, setTimes] = useState<ReadonlyMap<KernelId, MethodTimes>>(new Map());
  const measured = rows
    .map(({ evaluation: { state, method } }) => `${state.id} ${state.character.name} ${method.id}`)
    .join();
  useEffect(() => {
    const stop = new AbortController();
    const shown = rows.map(({ kernel, evaluation }) => ({ kernel, evaluation }));
    const timer = setTimeout(() => {
      const { wasm } = evaluations.pool.kernels;
      const usesGpu = session.skinDevice.peek() === 'gpu';
      attempt(
        { notice },
        measureTimes(viewer, shown, wasm, usesGpu, stop.signal).then(
          (found) => found && setTimes(found),
        ),
      );
    }, quietTime);
    return () => {
      clearTimeout(timer);
      stop.abort();
    };
    // The arrays behind the rows are overwritten with each pose; the times are of these methods.
  }, [measured]);
  return times;
}
