import type { GUI } from 'lil-gui';
import { loadPart } from '../../core/failure.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import { attempt } from '../attempt.ts';
import type { Editor } from '../editor.ts';
import { addNote } from './note.ts';

/** Adds a line that names the joint which mirrors one, if there is one. */
export function addPartnerNote(
  folder: GUI,
  editor: Pick<Editor, 'notice'>,
  skeleton: Skeleton,
  joint: number,
): void {
  const note = addNote(folder, '');
  note.hidden = true;
  attempt(editor, show());

  async function show(): Promise<void> {
    const { jointPairs } = await loadPart(import('../../posing/symmetry/joint-pairs.ts'));
    const { partners } = jointPairs(skeleton);
    const partner = partners[joint]!;
    if (partner < 0 || partner === joint) return;
    note.textContent = `Mirrors ${skeleton.names[partner]!}`;
    note.hidden = false;
  }
}
