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
  private readonly rows: ValueRow[] = [];
  private readonly folder: GUI;
  private readonly editor: Editor;
  private readonly joint: number;
  private readonly state: CharacterState;
  private built = false;

  constructor(parent: GUI, editor: Editor, state: CharacterState, joint: number) {
    this.editor = editor;
    this.state = state;
    this.joint = joint;
    this.folder = parent.addFolder(this.name).close();
    this.folder.onOpenClose((changed) => {
      if (changed !== this.folder) return;
      const { selectedJoint } = this.editor.session;
      if (!this.folder._closed) {
        this.build();
        selectedJoint.value = joint;
      } else if (selectedJoint.value === joint) selectedJoint.value = null;
    });
    this.folder.domElement.dataset['joint'] = String(joint);
  }

  /** Opens the folder and brings it into sight. */
  reveal(): void {
    this.build();
    this.folder.open();
    this.folder.domElement.scrollIntoView({ block: 'nearest' });
  }

  refresh(): void {
    for (const row of this.rows) row.refresh();
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
    const { skeleton } = this.state.character;
    for (const dof of axisDofs(skeleton, this.joint)) this.rows.push(this.addRow(dof));
    this.folder.add({ reset: () => this.reset() }, 'reset').name('Reset joint');
  }

  private addRow({ kind, axis, index }: AxisDof): ValueRow {
    const { store } = this.editor;
    const { id, character } = this.state;
    const { qMin, qMax, qRest } = character.skeleton;
    const isAngle = kind === DofKind.hinge;
    const reach = isAngle ? Math.PI : diagonal(character.bounds);
    const name = `${isAngle ? '' : 'Move '}${axisNames[axis]}`;
    const label = `${isAngle ? 'Turn' : 'Move'} ${this.name} ${axisNames[axis]}`;
    const fullName = `${this.name} ${name}`;
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
