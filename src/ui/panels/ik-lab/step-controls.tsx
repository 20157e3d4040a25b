import { useEffect } from 'preact/hooks';
import { numberOf } from '../../../posing/ik/lab.ts';
import type { IkLab, MethodRun } from '../../ik-lab.ts';

/** How long a whole run plays and a step stays at most, in milliseconds; and no step is shorter. */
const [wholeTime, longestStep, shortestStep] = [6000, 700, 60];

interface StepControlsProperties {
  readonly lab: IkLab;
  readonly run: MethodRun;
}

/** Goes through the steps of a method, by hand or by time. */
export function StepControls({ lab, run }: StepControlsProperties) {
  const [at, last, playing] = [lab.at.value, lab.lastStep.value, lab.playing.value];
  useEffect(() => {
    if (!playing) return;
    const time = Math.min(longestStep, Math.max(shortestStep, wholeTime / last));
    const timer = setInterval(() => lab.goTo(lab.at.peek() + 1), time);
    return () => clearInterval(timer);
  }, [lab, playing, last]);
  const [number, count] = [numberOf(run, at), numberOf(run, last)];
  const isFirst = at === 0;
  const isLast = at === last;
  return (
    <div class="steps">
      <Jump name="First step" sign="|◂" disabled={isFirst} run={() => lab.goTo(0)} />
      <Jump name="Previous step" sign="◂" disabled={isFirst} run={() => lab.goTo(at - 1)} />
      <button
        type="button"
        class="primary play"
        aria-label={playing ? 'Pause' : 'Play the steps'}
        title={playing ? 'Pause' : 'Play the steps'}
        disabled={last === 0}
        onClick={() => lab.togglePlay()}
      >
        {playing ? '❚❚' : '▶'}
      </button>
      <Jump name="Next step" sign="▸" disabled={isLast} run={() => lab.goTo(at + 1)} />
      <Jump name="Last step" sign="▸|" disabled={isLast} run={() => lab.goTo(last)} />
      <input
        type="range"
        aria-label="Step"
        aria-valuetext={`Step ${number} of ${count}`}
        min={0}
        max={Math.max(1, last)}
        step={1}
        disabled={last === 0}
        value={at}
        onInput={({ currentTarget }) => {
          lab.playing.value = false;
          lab.goTo(Number(currentTarget.value));
        }}
      />
      <output>
        {number} of {count}
      </output>
    </div>
  );
}

interface JumpProperties {
  readonly name: string;
  readonly sign: string;
  readonly disabled: boolean;
  readonly run: () => void;
}

function Jump({ name, sign, disabled, run }: JumpProperties) {
  return (
    <button type="button" aria-label={name} title={name} disabled={disabled} onClick={run}>
      {sign}
    </button>
  );
}
