import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import type { Character } from '../../core/character.ts';
import type { ActorId } from '../../document/scene.ts';
import type { Editor } from '../editor.ts';
import { addCommandRow } from './command-row.ts';
import { JointFolder } from './joint-folder.ts';
import { addNote } from './note.ts';
import { rotationOrder } from './rotation-order.ts';
import { addSearch } from './search-field.ts';

interface AllJointsOptions {
  /** Whether the list is what one works with: it is open, and its lines open when selected. */
  readonly first: boolean;
}

/**
 * Adds the degrees of freedom of all joints of the selected character, a line for each joint.
 * Returns what ends it.
 */
export function addAllJointsFolder(
  gui: GUI,
  editor: Editor,
  { first }: AllJointsOptions,
): () => void {
  const joints = gui.addFolder('All joints');
  joints.domElement.classList.add('joints');
  if (!first) joints.close();
  else {
    addCommandRow(gui, editor, 'previous-joint');
    addCommandRow(gui, editor, 'next-joint');
  }
  let folders: JointFolder[] = [];
  let shown: Character | null = null;
  /**
   * The rows write to the actor with this id. The same character may be opened again with another
   * id.
   */
  let shownId: ActorId | null = null;
  const sight = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      folders[Number((target as HTMLElement).dataset['joint'])]?.setInSight(isIntersecting);
    }
  });

  const endRows = effect(() => {
    const state = editor.evaluations.selected()?.state;
    const character = state?.character ?? null;
    if (character !== shown || (state?.id ?? null) !== shownId) {
      shown = character;
      shownId = state?.id ?? null;
      sight.disconnect();
      for (const child of [...joints.children]) child.destroy();
      joints.$children.replaceChildren();
      folders = [];
      if (state) {
        const { skeleton } = state.character;
        const order = rotationOrder(skeleton);
        if (order !== '') addNote(joints, `${order}, column vectors; angles in radians`);
        addSearch(joints, 'Search degrees of freedom', 'Search, as “knee x”', (wanted) => {
          for (const each of folders) each.filter(wanted);
        });
        for (let joint = 0; joint < skeleton.jointCount; joint++) {
          const folder = new JointFolder(joints, editor, state, joint, first);
          folders.push(folder);
          sight.observe(folder.element);
        }
      }
    }
    for (const each of folders) each.refresh();
  });
  let revealed: JointFolder | null = null;
  const endSelection = effect(() => {
    const joint = editor.session.selectedJoint.value;
    const next = (joint === null || !first ? null : folders[joint]) ?? null;
    // Lines that the user opened stay open; selecting another joint closes only the line that the
    // last selection opened.
    if (revealed !== next) revealed?.conceal();
    next?.reveal();
    revealed = next;
  });
  return () => {
    endRows();
    endSelection();
    sight.disconnect();
  };
}
