import { changeShot, type Shot } from '../../document/shots.ts';
import type { Editor } from '../editor.ts';
import { goToShot } from '../shots.ts';
import { AspectChoice } from './aspect-choice.tsx';
import { CommandButton } from './command-button.tsx';

/** The shots of the scene, and what can be changed of the one that is shown. */
export function ShotsPanel({ editor }: { readonly editor: Editor }) {
  const { shots } = editor.store.scene.value;
  return (
    <section class="shots" aria-labelledby="shots-title">
      <header>
        <h2 id="shots-title">Shots</h2>
        <CommandButton editor={editor} command="add-shot" />
      </header>
      <ul class="actors">
        {shots.map((shot) => (
          <ShotRow key={shot.id} editor={editor} shot={shot} />
        ))}
      </ul>
    </section>
  );
}

interface ShotRowProperties {
  readonly editor: Editor;
  readonly shot: Shot;
}

function ShotRow({ editor, shot }: ShotRowProperties) {
  const isShown = shot.id === editor.session.shownShot.value;
  return (
    <li class={isShown ? 'selected' : ''}>
      <button
        type="button"
        class="name"
        title={`Go to ${shot.name}`}
        aria-pressed={isShown}
        onClick={() => goToShot(editor, shot)}
      >
        <span class="text">{shot.name}</span>
        <span class="quiet">{shot.aspect === 'view' ? '' : shot.aspect}</span>
      </button>
      {isShown && (
        <>
          <CommandButton editor={editor} command="update-shot" />
          <CommandButton editor={editor} command="remove-shot" icon="remove" />
        </>
      )}
      {isShown && <ShotFields editor={editor} shot={shot} />}
    </li>
  );
}

function ShotFields({ editor, shot: { id, name } }: ShotRowProperties) {
  const rename = (value: string): void => {
    const given = value.trim();
    if (given === '') return;
    editor.store.dispatch(changeShot(id, { name: given }, `Rename ${name}`));
  };
  return (
    <div class="fields">
      <input
        type="text"
        aria-label="Name of the shot"
        maxLength={80}
        value={name}
        onChange={(event) => rename(event.currentTarget.value)}
      />
      <AspectChoice editor={editor} />
      <CommandButton editor={editor} command="thirds" />
    </div>
  );
}
