import { useMemo } from 'preact/hooks';
import type { Clip } from '../../../core/motion/clip.ts';
import type { Skeleton } from '../../../core/skeleton.ts';
import { firstRoot } from '../../../core/subtree.ts';
import { clipCurves, type Curve } from '../../clip-curves.ts';
import type { Looking, Posing } from '../../editor.ts';

interface ClipCurvesProperties {
  readonly editor: Looking & Posing;
  readonly clip: Clip;
  readonly skeleton: Skeleton;
  /** In seconds. */
  readonly time: number;
}

const width = 1000;
const height = 100;

/** The curves of the selected joint's values, or of the root's, over the range that is played. */
export function ClipCurves({ editor, clip, skeleton, time }: ClipCurvesProperties) {
  const joint = editor.session.selectedJoint.value ?? firstRoot(skeleton);
  const curves = useMemo(() => clipCurves(clip, skeleton, joint), [clip, skeleton, joint]);
  const { start, end } = clip;
  const across = (seconds: number): number => ((seconds - start) / (end - start || 1)) * width;
  // During playback only the playhead moves; an identical element is not rendered again.
  const paths = useMemo(
    () => curves.map((curve) => <CurvePath key={curve.name} curve={curve} across={across} />),
    [curves],
  );
  const seekAt = (event: MouseEvent): void => {
    const { left, width: shown } = (event.currentTarget as Element).getBoundingClientRect();
    editor.transport.seek(start + ((event.clientX - left) / shown) * (end - start));
  };
  const name = skeleton.names[joint] ?? '';
  return (
    <figure class="curves">
      <svg
        viewBox={`0 0 ${width} ${height}`}
        preserveAspectRatio="none"
        role="img"
        aria-label={`Curves of ${name}`}
        onPointerDown={seekAt}
        onPointerMove={(event) => event.buttons === 1 && seekAt(event)}
      >
        {paths}
        <line class="playhead" x1={across(time)} x2={across(time)} y1={0} y2={height} />
      </svg>
      <figcaption>
        {name}
        {curves.map((curve) => (
          <span key={curve.name} class={`axis-${curve.axis}`}>
            {curve.name}
          </span>
        ))}
        {curves.length === 0 && <span>the clip does not move it</span>}
      </figcaption>
    </figure>
  );
}

function CurvePath({ curve, across }: { curve: Curve; across: (seconds: number) => number }) {
  const down = (part: number): number => height * (0.94 - 0.88 * part);
  const points = curve.samples.map(({ time, part }) => `${across(time)},${down(part)}`);
  return (
    <g class={`axis-${curve.axis} ${curve.isAngle ? 'turn' : 'move'}`}>
      <polyline points={points.join(' ')} />
      {curve.keys.map(({ time, part }) => (
        // A line of length zero with round ends is a dot that stays round when the picture is
        // stretched.
        <path key={time} class="key" d={`M${across(time)} ${down(part)}h0`} />
      ))}
    </g>
  );
}
