import { offeredPoses, takeOffered } from '../../deform-lab/open-comparison.ts';
import type { Looking, Telling } from '../../editor.ts';

interface OfferedPosesProperties {
  readonly editor: Looking & Telling;
  /** Whether to say why they are offered. */
  readonly about?: boolean;
}

/** Buttons for poses in which methods differ; they are undone at the end of the comparison. */
export function OfferedPoses({ editor, about = false }: OfferedPosesProperties) {
  const poses = offeredPoses(editor);
  if (poses.length === 0) return null;
  return (
    <div class="offered" role="group" aria-label="Poses in which methods differ">
      {about && <span>In this pose the methods hardly differ.</span>}
      {poses.map(({ label }) => (
        <button key={label} type="button" onClick={() => takeOffered(editor, label)}>
          {label}
        </button>
      ))}
    </div>
  );
}
