import type { FunctionComponent } from 'preact';
import { loadPart } from '../core/failure.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Editor } from './editor.ts';
import { CharactersPanel } from './panels/characters-panel.tsx';
import { JointTree } from './panels/joint-tree.tsx';
import { StatusLine } from './panels/status-line.tsx';
import { WorkspacePanel } from './panels/workspace-panel.tsx';

export type SectionComponent = FunctionComponent<{ readonly editor: Editor }>;

/** A part of the page next to the view. To add one, write a file and add a row below. */
export interface Section {
  readonly id: string;
  readonly place: 'left' | 'foot';
  /** Whether the section has something to show; it is loaded when it first has. */
  readonly when: (editor: Editor) => boolean;
  readonly load: () => Promise<SectionComponent>;
}

const always = (): boolean => true;

/**
 * Every section, each place's from top to bottom. Sections that every visit shows are loaded at
 * once.
 */
export const sections: readonly Section[] = [
  {
    id: 'characters',
    place: 'left',
    when: always,
    load: () => Promise.resolve(CharactersPanel),
  },
  {
    id: 'problems',
    place: 'left',
    when: ({ session }) => session.problems.value.length > 0,
    load: async () => (await loadPart(import('./panels/problems-panel.tsx'))).ProblemsPanel,
  },
  {
    id: 'workspace',
    place: 'left',
    when: always,
    load: () => Promise.resolve(WorkspacePanel),
  },
  {
    id: 'joints',
    place: 'left',
    when: (editor) => jointCount(editor) > 0,
    load: () => Promise.resolve(JointTree),
  },
  {
    id: 'bone',
    place: 'left',
    when: (editor) => jointCount(editor) > 1,
    load: async () => (await loadPart(import('./panels/bone-panel.tsx'))).BonePanel,
  },
  {
    id: 'timeline',
    place: 'foot',
    // The timeline stays while a character without clips is selected, so that the view keeps its
    // height.
    when: ({ store }) => store.scene.value.actors.some(({ clips }) => clips.length > 0),
    load: async () => (await loadPart(import('./panels/timeline.tsx'))).Timeline,
  },
  {
    id: 'status',
    place: 'foot',
    when: always,
    load: () => Promise.resolve(StatusLine),
  },
];

function jointCount({ store, session }: Editor): number {
  return selectedActor(store, session)?.character.skeleton.jointCount ?? 0;
}
