import { setLook } from '../../document/look-edits.ts';
import type { Actor } from '../../document/scene.ts';
import { clayColors } from '../../view/theme.ts';
import type { Editor } from '../editor.ts';
import { hintAt } from '../hints.ts';
import { numberedNames } from '../numbered-names.ts';
import { CommandButton } from './command-button.tsx';
import { Icon } from './icon.tsx';
import { NameField } from './name-field.tsx';

/** The characters of the scene, one of them selected, and what adds more. */
export function Outliner({ editor }: { readonly editor: Editor }) {
  const { actors } = editor.store.scene.value;
  const { drawer } = editor;
  const hint = hintAt(editor.hints.value, 'outliner');
  const names = numberedNames(actors.map(({ name }) => name));
  return (
    <section class="outliner" aria-labelledby="characters-title">
      <header>
        <h2 id="characters-title">Characters</h2>
        <button
          type="button"
          class="unfold"
          aria-expanded={drawer.value === 'left'}
          aria-label="Characters and joints"
          title="Characters and joints"
          onClick={() => (drawer.value = drawer.value === 'left' ? null : 'left')}
        >
          <Icon id="list" />
        </button>
        <CommandButton editor={editor} command="gallery" class="primary add" />
      </header>
      <ul class="actors">
        {actors.map((actor, index) => (
          <ActorRow key={actor.id} editor={editor} actor={actor} name={names[index]!} />
        ))}
      </ul>
      {hint && <p class="hint">{hint.text}; they never leave this machine.</p>}
    </section>
  );
}

interface ActorRowProperties {
  readonly editor: Editor;
  readonly actor: Actor;
  readonly name: string;
}

function ActorRow({ editor, actor, name }: ActorRowProperties) {
  const { id, look } = actor;
  const isSelected = id === editor.session.selectedActorId.value;
  const label = look.visible ? `Hide ${name}` : `Show ${name}`;
  return (
    <li class={isSelected ? 'selected' : ''}>
      {editor.renaming.value === id ? (
        <NameField editor={editor} actor={actor} />
      ) : (
        <button
          type="button"
          class="name"
          title={`${name} (double-click to rename)`}
          aria-pressed={isSelected}
          onClick={() => editor.select(id)}
          onDblClick={() => (editor.renaming.value = id)}
        >
          <span class="clay" style={{ background: clayColors[look.clay] }} />
          <span class="text">{name}</span>
        </button>
      )}
      {isSelected && (
        <>
          <CommandButton editor={editor} command="duplicate-character" icon="copy" />
          <CommandButton editor={editor} command="remove-character" icon="remove" />
        </>
      )}
      <button
        type="button"
        title={label}
        aria-label={label}
        onClick={() => editor.store.dispatch(setLook(id, { visible: !look.visible }, label))}
      >
        <Icon id={look.visible ? 'eye' : 'hidden'} />
      </button>
    </li>
  );
}
