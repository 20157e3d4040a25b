import type { GUI } from 'lil-gui';
import { diagonal } from '../../core/bounds.ts';
import { axisDofs, type AxisDof } from '../../core/pose.ts';
import { DofKind } from '../../core/skeleton.ts';
import { resetJoint, setValue } from '../../document/commands.ts';
import type { CharacterState } from '../../document/document.ts';
import { shownSelected } from '../../document/shown-pose.ts';
import type { Editor } from '../editor.ts';
import { addValueRow, type ValueRow } from './value-row.ts';

const axisNames = ['X', 'Y', 'Z'] as const;

/**
 * A folder with the sliders of one joint. Its rows are built when it is first opened: a character
 * may have hundreds.
 */
export class JointFolder {
  private readonly rows: { readonly row: ValueRow; readonly fullName: string }[] = [];
  private readonly folder: GUI;
  private readonly editor: Editor;
  private readonly joint: number;
  private readonly state: CharacterState;
  private built = false;
  /** Opened by the selection or a search, not by hand. */
  private openedForShow = false;

  constructor(parent: GUI, editor: Editor, state: CharacterState, joint: number) {
    this.editor = editor;
    this.state = state;
    this.joint = joint;
    this.folder = parent.addFolder(this.name).close();
    this.folder.onOpenClose((changed) => {
      if (changed !== this.folder) return;
      const { selectedJoint } = this.editor.session;
      if (this.openedForShow) return;
      if (!this.folder._closed) {
        this.build();
        selectedJoint.value = joint;
      } else if (selectedJoint.value === joint) selectedJoint.value = null;
    });
    this.folder.domElement.dataset['joint'] = String(joint);
  }

  /** Opens the folder and brings it into sight. */
  reveal(): void {
    this.openForShow();
    this.folder.domElement.scrollIntoView({ block: 'nearest' });
  }

  /** Closes the folder again, where it was not the user who opened it. */
  conceal(): void {
    if (!this.openedForShow) return;
    this.folder.close();
    this.openedForShow = false;
  }

  /**
   * Shows the rows whose names have the words in them, and nothing where there is none.
   * @param wanted lower case; all is shown where it is empty
   */
  filter(wanted: string): void {
    const words = wanted.split(/\s+/);
    const matches = (name: string): boolean =>
      words.every((word) => name.toLowerCase().includes(word));
    const found = this.dofs.filter((dof) => matches(this.nameOf(dof)));
    this.folder.show(wanted === '' || found.length > 0);
    if (wanted !== '' && found.length > 0) this.openForShow();
    else if (wanted === '') this.conceal();
    for (const { row, fullName } of this.rows) row.show(wanted === '' || matches(fullName));
  }

  refresh(): void {
    for (const { row } of this.rows) row.refresh();
  }

  private openForShow(): void {
    if (!this.folder._closed) return;
    this.build();
    this.openedForShow = true;
    this.folder.open();
  }

  /** Slides before hinges, each by axis, whatever the order in which they act. */
  private get dofs(): readonly AxisDof[] {
    return axisDofs(this.state.character.skeleton, this.joint).sort(
      (a, b) => a.kind - b.kind || a.axis - b.axis,
    );
  }

  /** "Left knee X", "Hips Move Y". */
  private nameOf({ kind, axis }: AxisDof): string {
    return `${this.name} ${kind === DofKind.hinge ? '' : 'Move '}${axisNames[axis]}`;
  }

  private get name(): string {
    return this.state.character.skeleton.names[this.joint]!;
  }

  /** (qCount) the pose that is shown. */
  private get shown(): Float64Array {
    const { store, session } = this.editor;
    return shownSelected(store, session)?.pose.q ?? this.state.q;
  }

  private build(): void {
    if (this.built) return;
    this.built = true;
    for (const dof of this.dofs) {
      this.rows.push({ row: this.addRow(dof), fullName: this.nameOf(dof) });
    }
    this.folder.add({ reset: () => this.reset() }, 'reset').name('Reset joint');
  }

  private addRow(dof: AxisDof): ValueRow {
    const { kind, axis, index } = dof;
    const { store } = this.editor;
    const { id, character } = this.state;
    const { qMin, qMax, qRest } = character.skeleton;
    const isAngle = kind === DofKind.hinge;
    const reach = isAngle ? Math.PI : diagonal(character.bounds);
    const name = `${isAngle ? '' : 'Move '}${axisNames[axis]}`;
    const label = `${isAngle ? 'Turn' : 'Move'} ${this.name} ${axisNames[axis]}`;
    const fullName = this.nameOf(dof);
    const [least, most] = [qMin[index]!, qMax[index]!];
    return addValueRow(this.folder, {
      name,
      fullName,
      locked: least === most,
      minimum: Math.max(least, -reach),
      maximum: Math.min(most, reach),
      isAngle,
      legal: [least, most],
      read: () => this.shown[index] ?? 0,
      begin: () => {
        this.editor.session.activeDof.value = { name: fullName, index, isAngle };
        return store.begin(label);
      },
      preview: (gesture, value) => gesture.preview(setValue(id, this.shown, index, value, label)),
      reset: () => {
        store.dispatch(setValue(id, this.shown, index, qRest[index]!, `Reset ${fullName}`));
      },
    });
  }

  private reset(): void {
    this.editor.store.dispatch(resetJoint(this.state, this.shown, this.joint));
  }
}
