import type { GUI } from 'lil-gui';
import { diagonal } from '../../core/bounds.ts';
import { type Edit, resetJoint, setPose, setValue } from '../../document/edits.ts';
import type { Actor } from '../../document/scene.ts';
import type { Looking, Posing } from '../editor.ts';
import { axisNames, type JointValue, jointValues, valueName } from '../joint-values.ts';
import { addValueRow, type ValueRow } from './value-row.ts';

/**
 * A folder with the sliders of one joint. Its rows are built when it is first opened, because a
 * character may have hundreds of joints.
 */
export class JointFolder {
  private readonly rows: { readonly row: ValueRow; readonly fullName: string }[] = [];
  private readonly folder: GUI;
  private readonly editor: Looking & Posing;
  private readonly joint: number;
  private readonly state: Actor;
  private built = false;
  /** Whether the folder was opened by selection or search, not by hand. */
  private openedForShow = false;

  constructor(parent: GUI, editor: Looking & Posing, state: Actor, joint: number) {
    this.editor = editor;
    this.state = state;
    this.joint = joint;
    this.folder = parent.addFolder(this.name).close();
    this.folder.onOpenClose((changed) => {
      if (changed !== this.folder) return;
      const { selectedJoint } = this.editor.session;
      if (this.openedForShow) return;
      if (!this.folder._closed) {
        this.fill();
        selectedJoint.value = joint;
      } else if (selectedJoint.value === joint) selectedJoint.value = null;
    });
    this.folder.domElement.dataset['joint'] = String(joint);
  }

  /** Opens the folder and scrolls it into view. */
  reveal(): void {
    this.openForShow();
    this.folder.domElement.scrollIntoView({ block: 'nearest' });
  }

  /** Closes the folder again, unless the user opened it. */
  conceal(): void {
    if (!this.openedForShow) return;
    this.folder.close();
    this.openedForShow = false;
  }

  /**
   * Shows the rows whose names contain the text, and hides the folder if there is none.
   * @param wanted in lower case; if empty, all rows are shown
   */
  filter(wanted: string): void {
    const words = wanted.split(/\s+/);
    const matches = (name: string): boolean =>
      words.every((word) => name.toLowerCase().includes(word));
    const found = this.values.filter((value) => matches(this.nameOf(value)));
    this.folder.show(wanted === '' || found.length > 0);
    if (wanted !== '' && found.length > 0) this.openForShow();
    else if (wanted === '') this.conceal();
    for (const { row, fullName } of this.rows) row.show(wanted === '' || matches(fullName));
  }

  /** Updates the shown values. Rows in closed folders are updated when they are opened. */
  refresh(): void {
    if (!this.folder._closed) this.refreshRows();
  }

  private openForShow(): void {
    if (!this.folder._closed) return;
    this.fill();
    this.openedForShow = true;
    this.folder.open();
  }

  private get values(): readonly JointValue[] {
    return jointValues(this.state.character.skeleton, this.joint);
  }

  /** "Left knee X", "Hips Move Y". */
  private nameOf(value: JointValue): string {
    return `${this.name} ${valueName(value)}`;
  }

  private get name(): string {
    return this.state.character.skeleton.names[this.joint]!;
  }

  /** (qCount) the pose that is shown. */
  private get shown(): Float64Array {
    return this.editor.evaluations.selected()?.pose.q ?? this.state.q;
  }

  private fill(): void {
    if (this.built) this.refreshRows();
    else this.build();
  }

  private refreshRows(): void {
    for (const { row } of this.rows) row.refresh();
  }

  private build(): void {
    this.built = true;
    for (const value of this.values) {
      this.rows.push({ row: this.addRow(value), fullName: this.nameOf(value) });
    }
    this.folder.add({ reset: () => this.reset() }, 'reset').name('Reset joint');
  }

  private addRow(value: JointValue): ValueRow {
    const { isAngle, axis, index, ofBall } = value;
    const { store, session } = this.editor;
    const { bounds, skeleton } = this.state.character;
    const reach = isAngle ? Math.PI : diagonal(bounds);
    const fullName = this.nameOf(value);
    const label = `${isAngle ? 'Turn' : 'Move'} ${this.name} ${axisNames[axis]}`;
    const [least, most] = ofBall
      ? [-Infinity, Infinity]
      : [skeleton.qMin[index]!, skeleton.qMax[index]!];
    return addValueRow(this.folder, {
      name: valueName(value),
      fullName,
      locked: least === most,
      minimum: Math.max(least, -reach),
      maximum: Math.min(most, reach),
      isAngle,
      legal: [least, most],
      read: () => this.read(value, this.shown),
      begin: () => {
        const active = { name: fullName, index, isAngle };
        session.activeDof.value = ofBall ? { ...active, ballAxis: axis } : active;
        return store.begin(label);
      },
      preview: (gesture, number) => gesture.preview(this.write(value, number, label)),
      reset: () => {
        const rest = this.read(value, skeleton.qRest);
        store.dispatch(this.write(value, rest, `Reset ${fullName}`));
      },
    });
  }

  /** @param q a pose of the skeleton */
  private read({ index, axis, ofBall }: JointValue, q: Float64Array): number {
    if (!ofBall) return q[index] ?? 0;
    return this.editor.ballAngles.of(this.state.character.skeleton, q, index)[axis];
  }

  private write({ index, axis, ofBall }: JointValue, number: number, label: string): Edit {
    const { id, character } = this.state;
    if (!ofBall) return setValue(id, this.shown, index, number, label);
    const { ballAngles } = this.editor;
    const q = ballAngles.withAngle(character.skeleton, this.shown, index, axis, number);
    return setPose(id, q, label);
  }

  private reset(): void {
    this.editor.store.dispatch(resetJoint(this.state, this.shown, this.joint));
  }
}
