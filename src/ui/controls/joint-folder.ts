import type { GUI } from 'lil-gui';
import type { Actor } from '../../document/scene.ts';
import { resetJoints } from '../../document/edits.ts';
import { selectedJoints } from '../../document/selected-joints.ts';
import { selectJoints } from '../../document/select-joints.ts';
import type { Looking, Posing } from '../editor.ts';
import { jointValues } from '../joint-values.ts';
import { addJointValues, fullNameOf, jointName, type JointValueRow } from './joint-values.ts';

/**
 * A line of the list of all joints: the name and the joint's sliders side by side. Opened, it has
 * the full width, with a field for each number. Its rows are built when it first comes into sight,
 * because a character may have hundreds of joints.
 */
export class JointFolder {
  private rows: readonly JointValueRow[] = [];
  private readonly folder: GUI;
  private readonly editor: Looking & Posing;
  private readonly joint: number;
  private readonly state: Actor;
  private built = false;
  private inSight = false;
  /** Whether the folder was opened by selection, not by hand. */
  private openedForShow = false;

  /** @param opens whether the line can be opened */
  constructor(parent: GUI, editor: Looking & Posing, state: Actor, joint: number, opens: boolean) {
    this.editor = editor;
    this.state = state;
    this.joint = joint;
    this.folder = parent.addFolder(jointName(state, joint)).close();
    this.folder.onOpenClose((changed) => {
      if (changed !== this.folder || this.openedForShow) return;
      const { selectedJoint } = this.editor.session;
      if (!this.folder._closed) selectedJoint.value = joint;
      else if (selectedJoint.value === joint) selectedJoint.value = null;
      if (!opens) this.folder.close();
    });
    // A slider that was moved is what the user works on, so its line opens once it is let go.
    this.folder.onFinishChange(() => {
      const { session } = this.editor;
      const others = selectedJoints(session).filter((each) => each !== joint);
      const isOneOfThem = others.length < selectedJoints(session).length;
      selectJoints(session, isOneOfThem ? [joint, ...others] : [joint]);
    });
    this.element.dataset['joint'] = String(joint);
    this.element.title = jointName(state, joint);
  }

  get element(): HTMLElement {
    return this.folder.domElement;
  }

  /** Tells whether the line can be seen; only then it is kept up to date. */
  setInSight(inSight: boolean): void {
    this.inSight = inSight;
    if (!inSight) return;
    if (!this.built) this.build();
    this.refresh();
  }

  /** Opens the line and scrolls it into view. */
  reveal(): void {
    if (this.folder._closed) {
      this.setInSight(true);
      this.openedForShow = true;
      this.folder.open();
    }
    this.element.scrollIntoView({ block: 'nearest' });
  }

  /** Closes the line again, unless the user opened it. */
  conceal(): void {
    if (!this.openedForShow) return;
    this.folder.close();
    this.openedForShow = false;
  }

  /**
   * Shows the rows whose names contain the text, and hides the line if there is none.
   * @param wanted in lower case; if empty, all rows are shown
   */
  filter(wanted: string): void {
    const words = wanted.split(/\s+/);
    const matches = (name: string): boolean =>
      words.every((word) => name.toLowerCase().includes(word));
    const names = jointValues(this.state.character.skeleton, this.joint).map((value) =>
      fullNameOf(this.state, this.joint, value),
    );
    const isFound = names.some(matches);
    this.folder.show(wanted === '' || isFound);
    if (isFound && wanted !== '') this.setInSight(true);
    for (const row of this.rows) row.show(wanted === '' || matches(row.fullName));
  }

  /** Updates the shown values. */
  refresh(): void {
    if (!this.inSight) return;
    for (const row of this.rows) row.refresh();
  }

  private build(): void {
    this.built = true;
    const { folder, editor, state, joint } = this;
    this.rows = addJointValues(folder, editor, state, joint);
    const reset = (): void => {
      const shown = editor.evaluations.selected()?.poseToEdit.q ?? state.q;
      const label = `Reset ${jointName(state, joint)}`;
      editor.store.dispatch(resetJoints(state, shown, [joint], label));
    };
    folder.add({ reset }, 'reset').name('Reset joint');
  }
}
