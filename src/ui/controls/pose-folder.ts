import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import type { Character } from '../../core/character.ts';
import type { ActorId } from '../../document/scene.ts';
import type { Editor } from '../editor.ts';
import { addCommandRow } from './command-row.ts';
import { JointFolder } from './joint-folder.ts';
import { rotationOrder } from './rotation-order.ts';

/** Adds all degrees of freedom of the selected character, and commands for its pose. */
export function addPoseFolder(gui: GUI, editor: Editor): void {
  const folder = gui.addFolder('Pose');
  // Two commands per row.
  addCommandRow(folder, editor, 'previous-joint');
  addCommandRow(folder, editor, 'next-joint');
  addCommandRow(folder, editor, 'reset-pose');
  addCommandRow(folder, editor, 'copy-pose');
  addCommandRow(folder, editor, 'open-pose');
  addCommandRow(folder, editor, 'save-pose');
  addCommandRow(folder, editor, 'export-mesh');
  let joints: GUI | null = null;
  let folders: JointFolder[] = [];
  let shown: Character | null = null;
  /**
   * The rows write to the actor with this id. The same character may be opened again with another
   * id.
   */
  let shownId: ActorId | null = null;

  effect(() => {
    const state = editor.evaluations.selected()?.state;
    const character = state?.character ?? null;
    if (character !== shown || (state?.id ?? null) !== shownId) {
      joints?.destroy();
      joints = folder.addFolder('Joints');
      joints.domElement.classList.add('joints');
      shown = character;
      shownId = state?.id ?? null;
      folders = [];
      if (state) {
        const { skeleton } = state.character;
        addNote(joints, rotationOrder(skeleton));
        addSearch(joints, (wanted) => {
          for (const each of folders) each.filter(wanted);
        });
        for (let joint = 0; joint < skeleton.jointCount; joint++) {
          folders.push(new JointFolder(joints, editor, state, joint));
        }
      }
    }
    for (const each of folders) each.refresh();
  });
  let revealed: JointFolder | null = null;
  effect(() => {
    const joint = editor.session.selectedJoint.value;
    const next = (joint === null ? null : folders[joint]) ?? null;
    // Folders that the user opened stay open; selecting another joint closes only the folder that
    // the last selection opened.
    if (revealed !== next) revealed?.conceal();
    next?.reveal();
    revealed = next;
  });
}

function addSearch(folder: GUI, filter: (wanted: string) => void): void {
  const field = document.createElement('input');
  field.type = 'search';
  field.className = 'dof-search';
  field.placeholder = 'Search, as “knee x”';
  field.setAttribute('aria-label', 'Search degrees of freedom');
  field.addEventListener('input', () => filter(field.value.trim().toLowerCase()));
  folder.$children.append(field);
}

function addNote(folder: GUI, text: string): void {
  if (text === '') return;
  const note = document.createElement('p');
  note.className = 'note';
  note.textContent = `${text}, column vectors; angles in radians`;
  folder.$children.append(note);
}
