import { useMemo } from 'preact/hooks';
import { runCommand } from '../../commands/command.ts';
import { commandOf } from '../../commands/registry.ts';
import type { Editor } from '../../editor.ts';
import { insertText } from '../../rotation-lab/insert-rotation-key.ts';
import type { RotationLab } from '../../rotation-lab/rotation-lab.ts';
import type { Subject } from '../../rotation-lab/subject.ts';

interface InsertKeyProperties {
  readonly editor: Editor;
  readonly lab: RotationLab;
  readonly subject: Subject;
}

/** Inserts a key at the playhead, and says before what that will change. */
export function InsertKey({ editor, lab, subject }: InsertKeyProperties) {
  const isPlaying = editor.session.playing.value;
  // What it changes takes a while to compute, and nobody can read it while a clip plays.
  const time = isPlaying ? null : lab.time.value;
  const text = useMemo(() => (time === null ? '' : insertText(subject, time)), [subject, time]);
  return (
    <section class="insert" aria-label="Insert a key">
      <button
        type="button"
        aria-describedby="rotation-lab-insert"
        onClick={() => runCommand(commandOf('insert-rotation-key'), editor)}
      >
        Insert a key here
      </button>
      <p class="hint" id="rotation-lab-insert">
        {text && `It ${text}.`}
      </p>
    </section>
  );
}
