import type { FunctionComponent } from 'preact';
import { loadPart } from '../core/failure.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Actor } from '../document/scene.ts';
import type { Editor } from './editor.ts';
import { addAllJointsFolder } from './controls/all-joints-folder.ts';
import { guiSection } from './controls/gui-section.tsx';
import { addSelectedJointFolder } from './controls/selected-joint-folder.ts';
import { JointTree } from './panels/joint-tree.tsx';
import { Outliner } from './panels/outliner.tsx';
import { StatusLine } from './panels/status-line.tsx';
import { Subject } from './panels/subject.tsx';
import type { TabId } from './tabs.ts';
import { showsStressSheet } from './deform-lab/measures-open.ts';
import { hasSteps } from './take-step.ts';
import type { Workspace } from './workspace.ts';

export type SectionComponent = FunctionComponent<{ readonly editor: Editor }>;

/** A part of the page next to the view. To add one, write a file and add a row below. */
export interface Section {
  readonly id: string;
  /** The outliner on the left, the inspector on the right, or the foot of the page. */
  readonly place: 'left' | 'right' | 'foot';
  /** The tabs in which the section stands; all, if absent. */
  readonly tabs?: readonly TabId[];
  /** Whether the section has something to show; always, if absent. It is loaded when it first has. */
  readonly when?: (editor: Editor) => boolean;
  readonly load: () => Promise<SectionComponent>;
}

/**
 * Every section, each place's from top to bottom. Sections that every visit shows are loaded at
 * once.
 */
export const sections: readonly Section[] = [
  { id: 'outliner', place: 'left', load: () => Promise.resolve(Outliner) },
  {
    id: 'joints',
    place: 'left',
    when: (editor) => jointCount(editor) > 0,
    load: () => Promise.resolve(JointTree),
  },
  {
    id: 'problems',
    place: 'right',
    when: ({ session }) => session.problems.value.length > 0,
    load: async () => (await loadPart(import('./panels/problems-panel.tsx'))).ProblemsPanel,
  },
  { id: 'subject', place: 'right', load: () => Promise.resolve(Subject) },
  {
    id: 'all-joints-first',
    place: 'right',
    tabs: ['pose', 'animate'],
    when: (editor) => listsJoints(editor) && jointCount(editor) > 0,
    load: () => Promise.resolve(openJoints),
  },
  {
    id: 'joint',
    place: 'right',
    tabs: ['pose', 'animate'],
    when: (editor) => !listsJoints(editor),
    load: () => Promise.resolve(selectedJoint),
  },
  {
    id: 'morphs',
    place: 'right',
    tabs: ['pose', 'animate'],
    load: async () =>
      guiSection((await loadPart(import('./controls/morph-folder.ts'))).addMorphFolder),
  },
  {
    id: 'pose',
    place: 'right',
    tabs: ['pose', 'animate'],
    load: async () =>
      guiSection((await loadPart(import('./controls/pose-folder.ts'))).addPoseFolder),
  },
  {
    id: 'motion',
    place: 'right',
    tabs: ['animate'],
    when: (editor) => jointCount(editor) > 0,
    load: async () =>
      guiSection((await loadPart(import('./controls/motion-view-folder.ts'))).addMotionViewFolder),
  },
  {
    id: 'poses',
    place: 'right',
    tabs: ['pose'],
    when: (editor) => jointCount(editor) > 0,
    load: async () => (await loadPart(import('./panels/pose-library.tsx'))).PoseLibraryPanel,
  },
  {
    id: 'ik',
    place: 'right',
    tabs: ['pose'],
    when: (editor) => jointCount(editor) > 0,
    load: async () => guiSection((await loadPart(import('./controls/ik-folder.ts'))).addIkFolder),
  },
  {
    id: 'pins',
    place: 'right',
    tabs: ['pose'],
    when: (editor) => jointCount(editor) > 0,
    load: async () =>
      guiSection((await loadPart(import('./controls/pins-folder.ts'))).addPinsFolder),
  },
  {
    id: 'ik-lab',
    place: 'right',
    tabs: ['pose'],
    when: (editor) => jointCount(editor) > 0,
    load: async () => (await loadPart(import('./panels/ik-lab.tsx'))).IkLabPanel,
  },
  {
    id: 'rotation-lab',
    place: 'right',
    tabs: ['animate'],
    when: (editor) => jointCount(editor) > 0,
    load: async () => (await loadPart(import('./panels/rotation-lab.tsx'))).RotationLabPanel,
  },
  {
    id: 'deform-lab',
    place: 'right',
    tabs: ['deform'],
    load: async () => (await loadPart(import('./panels/deform-lab-panel.tsx'))).DeformLabPanel,
  },
  {
    id: 'vertex-inspector',
    place: 'right',
    tabs: ['deform'],
    load: async () => (await loadPart(import('./panels/vertex-inspector.tsx'))).VertexInspector,
  },
  {
    id: 'method',
    place: 'right',
    tabs: ['deform'],
    load: async () =>
      guiSection((await loadPart(import('./controls/skin-folder.ts'))).addSkinFolder),
  },
  {
    id: 'weights',
    place: 'right',
    tabs: ['deform'],
    load: async () =>
      guiSection((await loadPart(import('./controls/weights-folder.ts'))).addWeightsFolder),
  },
  {
    id: 'measures',
    place: 'right',
    tabs: ['deform'],
    when: (editor) => jointCount(editor) > 0,
    load: async () => (await loadPart(import('./panels/deform-lab/measures.tsx'))).Measures,
  },
  {
    id: 'cutting-figure',
    place: 'right',
    tabs: ['deform'],
    when: (editor) => jointCount(editor) > 0,
    load: async () =>
      (await loadPart(import('./panels/deform-lab/cutting-figure.tsx'))).CuttingFigurePanel,
  },
  {
    id: 'drag',
    place: 'right',
    tabs: ['pose'],
    load: async () =>
      guiSection((await loadPart(import('./controls/bone-folder.ts'))).addBoneFolder),
  },
  {
    id: 'place',
    place: 'right',
    tabs: ['pose'],
    load: async () =>
      guiSection((await loadPart(import('./controls/place-folder.ts'))).addPlaceFolder),
  },
  {
    id: 'all-joints',
    place: 'right',
    tabs: ['pose'],
    when: (editor) => !listsJoints(editor) && jointCount(editor) > 0,
    load: () => Promise.resolve(foldedJoints),
  },
  {
    id: 'bone',
    place: 'right',
    tabs: ['pose', 'deform'],
    when: (editor) =>
      jointCount(editor) > 1 && (editor.tab.value === 'deform' || workspaceOf(editor).showsBones),
    load: async () => (await loadPart(import('./panels/bone-panel.tsx'))).BonePanel,
  },
  {
    id: 'surface',
    place: 'right',
    tabs: ['deform'],
    load: async () =>
      guiSection((await loadPart(import('./controls/look-folder.ts'))).addLookFolder),
  },
  {
    id: 'camera',
    place: 'right',
    load: async () =>
      guiSection((await loadPart(import('./controls/camera-folder.ts'))).addCameraFolder),
  },
  {
    id: 'shots',
    place: 'right',
    load: async () => (await loadPart(import('./panels/shots-panel.tsx'))).ShotsPanel,
  },
  {
    id: 'view',
    place: 'right',
    load: async () =>
      guiSection((await loadPart(import('./controls/view-folder.ts'))).addViewFolder),
  },
  {
    id: 'environment',
    place: 'right',
    load: async () =>
      guiSection((await loadPart(import('./controls/environment-folder.ts'))).addEnvironmentFolder),
  },
  {
    id: 'picture',
    place: 'right',
    load: async () =>
      guiSection((await loadPart(import('./controls/picture-folder.ts'))).addPictureFolder),
  },
  {
    id: 'history',
    place: 'right',
    when: ({ store }) => hasSteps(store),
    load: async () => (await loadPart(import('./panels/history-panel.tsx'))).HistoryPanel,
  },
  {
    id: 'timeline',
    place: 'foot',
    tabs: ['animate'],
    when: ({ store }) => store.scene.value.actors.some(canMove),
    load: async () => (await loadPart(import('./panels/timeline/timeline.tsx'))).Timeline,
  },
  {
    id: 'stress',
    place: 'foot',
    tabs: ['deform'],
    when: () => showsStressSheet.value,
    load: async () => (await loadPart(import('./panels/deform-lab/stress-sheet.tsx'))).StressSheet,
  },
  { id: 'status', place: 'foot', load: () => Promise.resolve(StatusLine) },
];

const selectedJoint = guiSection(addSelectedJointFolder);
const openJoints = guiSection((gui, editor) => addAllJointsFolder(gui, editor, { first: true }));
const foldedJoints = guiSection((gui, editor) => addAllJointsFolder(gui, editor, { first: false }));

/** Whether the workspace shows the numbers of all joints at once, instead of the selected one's. */
function listsJoints(editor: Editor): boolean {
  return workspaceOf(editor).listsJoints;
}

function workspaceOf({ workspaces, workspaceId }: Editor): Workspace {
  return workspaces.find(({ id }) => id === workspaceId.value)!;
}

/** Whether a clip can move something of an actor. */
function canMove({ character, clips }: Actor): boolean {
  return character.skeleton.jointCount + character.morphs.length + clips.length > 0;
}

function jointCount({ store, session }: Editor): number {
  return selectedActor(store, session)?.character.skeleton.jointCount ?? 0;
}
