import type { IkLab, Subject } from '../../ik-lab.ts';
import { conditionOf, conditionText, flatnessText, limitText } from '../../ik-lab-text.ts';

interface StepFactsProperties {
  readonly lab: IkLab;
  readonly subject: Subject;
}

/** How small turns can move the joint at the shown step, and which limits the limb has met. */
export function StepFacts({ lab, subject: { chain } }: StepFactsProperties) {
  const step = lab.step.value;
  if (!step) return null;
  const ellipsoid = lab.ellipsoid.value;
  const condition = conditionOf(ellipsoid);
  const longest = ellipsoid[0]?.size ?? 0;
  const flatness = flatnessText(chain, step.q, ellipsoid);
  return (
    <>
      <h3>How small turns move it</h3>
      <ul class="singular" aria-label="Singular values of the Jacobian">
        {ellipsoid.map(({ size }, i) => (
          <li key={i}>
            <span>σ{['₁', '₂', '₃'][i]}</span>
            <span class="bar" aria-hidden="true">
              <span style={{ width: `${longest > 0 ? (100 * size) / longest : 0}%` }} />
            </span>
            <span class="number">{size.toFixed(3)}</span>
          </li>
        ))}
      </ul>
      <p class="hint">
        {condition === null
          ? 'No turn moves it.'
          : `Chain lengths per radian, along the axes of the ellipsoid in the view. Condition number: ${conditionText(condition)}.`}
      </p>
      {flatness && <p class="warning">{flatness}</p>}
      <h3>Limits met</h3>
      {step.atLimits.length === 0 ? (
        <p class="hint">None.</p>
      ) : (
        <ul class="limits">
          {step.atLimits.map((index) => (
            <li key={index}>{limitText(chain.skeleton, step.q, index)}</li>
          ))}
        </ul>
      )}
    </>
  );
}
