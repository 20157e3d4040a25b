import { setPose } from '../document/edits.ts';
import { noPartner } from '../posing/symmetry/joint-pairs.ts';
import {
  mirrorJoints,
  type MirroredPose,
  type Symmetry,
  symmetryOf,
} from '../posing/symmetry/symmetry.ts';
import type { Editor } from './editor.ts';
import { type ScopedJoints, scopedJoints } from './pose-scope.ts';

/** The side whose pose the other one gets. */
export type FromSide = 'left' | 'right';

/** Mirrors the joints in scope with their partners, each in the place of the other. */
export function mirrorInPlace(editor: Editor): void {
  mirror(editor, 'Mirror the pose', {
    sources: ({ partners }, joints) => [...new Set(joints.flatMap((j) => [j, partners[j]!]))],
    told: ({ isWhole, name }, partner) =>
      isWhole ? 'The pose is mirrored' : `${name} mirrored${partner && `, with ${partner}`}`,
  });
}

/** Gives the joints of one side, as far as they or their partners are in scope, to the other. */
export function mirrorOnto(editor: Editor, from: FromSide): void {
  const sign = from === 'left' ? 1 : -1;
  const source = from === 'left' ? 'Left' : 'Right';
  const target = from === 'left' ? 'right' : 'left';
  mirror(editor, `${source} onto ${target}`, {
    sources: ({ partners, sides }, joints) =>
      [...new Set(joints.flatMap((j) => [j, partners[j]!]))].filter((j) => sides[j] === sign),
    told: ({ isWhole, name }, partner, isSource) => {
      if (isWhole || !partner) return `${source} mirrored onto ${target}`;
      return isSource ? `${name} mirrored onto ${partner}` : `${partner} mirrored onto ${name}`;
    },
    from: sign,
  });
}

interface Mirroring {
  /** The joints whose partners get their pose, among them joints without partner. */
  readonly sources: (symmetry: Symmetry, joints: readonly number[]) => readonly number[];
  /**
   * @param partner the name of the selected joint's partner, or empty
   * @param isSource whether the selected joint is on the side that is given
   */
  readonly told: (scoped: ScopedJoints, partner: string, isSource: boolean) => string;
  /** The sign of the side that is given, if it is one. */
  readonly from?: 1 | -1;
}

function mirror(editor: Editor, label: string, { sources, told, from }: Mirroring): void {
  const { store, session, evaluations, notice } = editor;
  const shown = evaluations.selected();
  if (!shown) return;
  const { state, poseToEdit } = shown;
  const { skeleton } = state.character;
  const symmetry = symmetryOf(skeleton);
  const { partners, sides } = symmetry;
  const scoped = scopedJoints(session, skeleton);
  const alone = scoped.joints.filter((joint) => partners[joint] === noPartner);
  const wanted = sources(symmetry, scoped.joints).filter(
    (joint) => joint >= 0 && partners[joint] !== noPartner,
  );
  if (wanted.length === 0) {
    notice.value = `${state.name} has no left and right here to mirror`;
    return;
  }
  const mirrored = mirrorJoints(symmetry, poseToEdit.q, poseToEdit.q, wanted);
  store.dispatch(setPose(state.id, mirrored.q, label));
  const selected = session.selectedJoint.value ?? noPartner;
  const partner = partners[selected] ?? noPartner;
  const hasPartner = scoped.name === skeleton.names[selected] && partner !== selected;
  const name = hasPartner && partner !== noPartner ? skeleton.names[partner]! : '';
  const text = told(scoped, name, sides[selected] === from);
  notice.value = `${text}${mirrorRemarks({ ...mirrored, alone })}`;
}

/** What did not go as asked: joints without partner, and joints that reached a limit. */
export function mirrorRemarks({ alone, stopped }: Omit<MirroredPose, 'q'>): string {
  const remarks: string[] = [];
  const joints = (count: number): string => (count === 1 ? '1 joint' : `${count} joints`);
  if (alone.length > 0) {
    remarks.push(`${joints(alone.length)} ${alone.length === 1 ? 'has' : 'have'} no partner`);
  }
  if (stopped.length > 0) remarks.push(`${joints(stopped.length)} stopped at a limit`);
  return remarks.map((remark) => `; ${remark}`).join('');
}
