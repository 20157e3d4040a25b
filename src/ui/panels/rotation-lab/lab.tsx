import '../../styles/rotation-lab.css';
import { useEffect, useMemo } from 'preact/hooks';
import type { Editor } from '../../editor.ts';
import { RotationLab } from '../../rotation-lab/rotation-lab.ts';
import { ChartFigure } from './chart-figure.tsx';
import { ChartValuesTable } from './chart-values-table.tsx';
import { CurveKinds } from './curve-kinds.tsx';
import { InsertKey } from './insert-key.tsx';

/** Explains rotations over time: one motion in three charts, and by three kinds of curves. */
export function Lab({ editor }: { readonly editor: Editor }) {
  const lab = useMemo(() => new RotationLab(editor), [editor]);
  useEffect(() => () => lab.dispose(), [lab]);
  const subject = lab.subject.value;
  if (!subject) return <p class="hint">{lab.refusal.value}</p>;
  return (
    <>
      <p class="about">
        <strong>{subject.name}</strong>, one motion in three charts. Twist is about{' '}
        {subject.boneName}.
      </p>
      {subject.curves.map((curve) => (
        <ChartFigure key={curve.chart.id} editor={editor} lab={lab} curve={curve} />
      ))}
      <ChartValuesTable lab={lab} subject={subject} />
      <CurveKinds editor={editor} lab={lab} subject={subject} />
      <InsertKey editor={editor} lab={lab} subject={subject} />
    </>
  );
}
