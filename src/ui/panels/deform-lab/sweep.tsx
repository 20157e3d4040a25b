import '../../styles/sweep.css';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { standaloneSvg } from '../../deform-lab/standalone-svg.ts';
import { nameOf, SweepLab } from '../../deform-lab/sweep-lab.ts';
import { plotSize } from '../../deform-lab/sweep-plot.ts';
import type { Editor } from '../../editor.ts';
import { axisNames } from '../../joint-values.ts';
import { Measuring } from './measuring.tsx';
import { MethodChoice } from './method-choice.tsx';
import { SweepFigure } from './sweep-figure.tsx';
import { SweepTable } from './sweep-table.tsx';

/** Turns a joint over its range and shows what methods do to volume and cross-section. */
export function Sweep({ editor }: { readonly editor: Editor }) {
  const lab = useMemo(() => new SweepLab(editor), [editor]);
  const [volumes, sections] = [useRef<SVGSVGElement>(null), useRef<SVGSVGElement>(null)];
  useEffect(() => {
    lab.sweep();
    return () => lab.measurement.cancel();
  }, [lab]);
  const { measurement } = lab;
  const [progress, sweep] = [measurement.progress.value, measurement.result.value];
  const [actor, joint, range] = [lab.actor.value, lab.joint.value, lab.range.value];
  if (!actor || actor.character.mesh.pointCount === 0) {
    return <p class="hint">Select a character with a mesh.</p>;
  }
  if (joint === null || !range) return <p class="hint">No joint of it can turn.</p>;
  const { skeleton } = actor.character;
  const savePicture = (): void => {
    const elements = [volumes.current, sections.current].filter((element) => element !== null);
    lab.savePicture(standaloneSvg(elements.map((element) => ({ element, ...plotSize }))));
  };
  return (
    <>
      <p class="hint">
        Turns one joint about one axis over its range, from the pose that is shown, and measures
        what each method does.
      </p>
      <div class="subject">
        <label>
          Joint
          <select
            value={joint}
            onChange={({ currentTarget }) => lab.chooseJoint(Number(currentTarget.value))}
          >
            {lab.joints.value.map((each) => (
              <option key={each} value={each}>
                {nameOf(skeleton, each)}
              </option>
            ))}
          </select>
        </label>
        <label>
          Axis
          <select
            value={range.axis}
            onChange={({ currentTarget }) =>
              lab.chooseAxis(Number(currentTarget.value) as 0 | 1 | 2)
            }
          >
            {lab.ranges.value.map(({ axis }) => (
              <option key={axis} value={axis}>
                {axisNames[axis]}
              </option>
            ))}
          </select>
        </label>
      </div>
      <MethodChoice chosen={lab.chosen.value} toggle={(method) => lab.toggleMethod(method)} />
      {progress ? (
        <Measuring progress={progress} cancel={() => measurement.cancel()} />
      ) : (
        <button type="button" onClick={() => lab.sweep()}>
          Sweep from the present pose
        </button>
      )}
      {sweep && (
        <>
          <SweepFigure sweep={sweep} quantity="volumes" drawing={volumes} />
          <SweepFigure sweep={sweep} quantity="sections" drawing={sections} />
          <SweepTable sweep={sweep} />
          <div class="buttons">
            <button type="button" onClick={() => lab.saveCsv()}>
              Save table (CSV)
            </button>
            <button type="button" onClick={savePicture}>
              Save picture (SVG)
            </button>
          </div>
          <p class="hint">
            The section is the outline that the plane through the joint, at a right angle to its
            bone, cuts out of the skin at rest. It moves with the skin, and its area is measured.
            The volume is that of closed parts of the mesh.
          </p>
        </>
      )}
    </>
  );
}
