import { useEffect, useMemo } from 'preact/hooks';
import type { Editor } from '../../editor.ts';
import { IkLab, type LabMethod } from '../../ik-lab.ts';
import { partText } from '../../ik-lab-text.ts';
import { MethodTabs } from './method-tabs.tsx';
import { ResidualPlot } from './residual-plot.tsx';
import { StepControls } from './step-controls.tsx';
import { StepFacts } from './step-facts.tsx';
import { Target } from './target.tsx';

interface LabProperties {
  readonly editor: Editor;
  readonly methods: readonly LabMethod[];
}

/** Explains inverse kinematics: what each method does to bring the selected joint to a target. */
export function Lab({ editor, methods }: LabProperties) {
  const lab = useMemo(() => new IkLab(editor, methods), [editor, methods]);
  useEffect(() => () => lab.dispose(), [lab]);
  const [subject, run] = [lab.subject.value, lab.run.value];
  if (!subject || !run) return <p class="hint">{lab.refusal.value}</p>;
  const step = lab.step.value;
  return (
    <>
      <Target lab={lab} subject={subject} />
      <MethodTabs lab={lab} />
      <div role="tabpanel" id="ik-lab-method" aria-label={run.method.label}>
        <StepControls lab={lab} run={run} />
        <p class="said" aria-live="polite">
          {step?.text}{' '}
          <span class="hint">{partText(step?.error ?? 0)} of the chain’s length is left.</span>
        </p>
        <button type="button" class="apply" onClick={() => lab.apply()}>
          Apply this pose
        </button>
        <ResidualPlot lab={lab} />
        <StepFacts lab={lab} subject={subject} />
        <h3>{run.method.label}</h3>
        <p class="hint">{run.method.summary}</p>
      </div>
    </>
  );
}
