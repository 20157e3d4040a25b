import type { Actor } from '../../../document/scene.ts';
import type { LibraryPose, PoseLibrary } from '../../pose-library.ts';

interface BlendSliderProperties {
  readonly library: PoseLibrary;
  readonly actor: Actor;
  readonly pose: LibraryPose;
}

/** Blends a pose in, from what was shown before it was applied; a drag is one step of undo. */
export function BlendSlider({ library, actor, pose }: BlendSliderProperties) {
  const fraction = library.fractionOf(actor, pose);
  const percent = Math.round(100 * (fraction ?? 1));
  return (
    <div class="blend">
      <span aria-hidden="true">Blend</span>
      <input
        type="range"
        aria-label={`Blend in ${pose.name}`}
        aria-valuetext={`${percent} %`}
        min="0"
        max="100"
        step="1"
        disabled={fraction === null}
        value={percent}
        onInput={({ currentTarget }) => library.blend(pose, Number(currentTarget.value) / 100)}
        onChange={() => library.endBlend()}
      />
      <output>{percent} %</output>
      <button
        type="button"
        title={`Apply the mirror image of ${pose.name}`}
        onClick={() => library.applyMirrored(pose)}
      >
        Mirrored
      </button>
    </div>
  );
}
