import '../styles/poses.css';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Actor } from '../../document/scene.ts';
import type { Editor } from '../editor.ts';
import { type LibraryPose, type PoseLibrary, poseLibraryOf } from '../pose-library.ts';
import { BlendSlider } from './pose-library/blend-slider.tsx';
import { PoseThumbnail } from './pose-library/pose-thumbnail.tsx';
import { SavedPoseFields } from './pose-library/saved-pose-fields.tsx';
import { CommandButton } from './command-button.tsx';

/**
 * The library of poses: those that come with the character, and those of the scene. A press applies
 * one; a slider blends the last one in and out.
 */
export function PoseLibraryPanel({ editor }: { readonly editor: Editor }) {
  const actor = selectedActor(editor.store, editor.session);
  if (!actor) return null;
  const library = poseLibraryOf(editor);
  const poses = library.posesFor(actor);
  const chosen = library.chosenFor(actor);
  return (
    <section class="poses" aria-labelledby="poses-title">
      <header>
        <h2 id="poses-title">Pose library</h2>
        <CommandButton editor={editor} command="keep-pose" />
      </header>
      {poses.length === 0 && <p class="hint">Poses that you keep are saved with the scene.</p>}
      <ul class="cards">
        {poses.map((pose) => (
          <PoseCard
            key={pose.key}
            {...{ editor, library, actor, pose, isChosen: pose.key === chosen?.key }}
          />
        ))}
      </ul>
      {chosen && <BlendSlider library={library} actor={actor} pose={chosen} />}
      {chosen?.saved && <SavedPoseFields editor={editor} pose={chosen.saved} />}
      {editor.session.selectedJoint.value !== null && (
        <div class="parts">
          <span>Keep a part</span>
          <CommandButton editor={editor} command="keep-branch" />
          <CommandButton editor={editor} command="keep-joints" />
        </div>
      )}
    </section>
  );
}

interface PoseCardProperties {
  readonly editor: Editor;
  readonly library: PoseLibrary;
  readonly actor: Actor;
  readonly pose: LibraryPose;
  readonly isChosen: boolean;
}

function PoseCard({ editor, library, actor, pose, isChosen }: PoseCardProperties) {
  const fits = library.fits(actor, pose);
  return (
    <li>
      <button
        type="button"
        title={fits ? `Apply ${pose.name}` : `${actor.name} has no joint of ${pose.name}`}
        aria-pressed={isChosen}
        disabled={!fits}
        onClick={() => library.apply(pose)}
      >
        <PoseThumbnail editor={editor} actor={actor} pose={pose} />
        <span>{pose.name}</span>
      </button>
    </li>
  );
}
