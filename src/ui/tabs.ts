export type TabId = 'pose' | 'animate' | 'deform';

/** A task of the page; it decides which sections stand in the inspector. */
export interface Tab {
  readonly id: TabId;
  readonly label: string;
  /** Whether the timeline is its work, so that on a phone its sheet waits for a second press. */
  readonly isTimeline?: true;
}

/** Every tab, from left to right. To add one, add a row here and name it in the rows of sections.ts. */
export const tabs: readonly Tab[] = [
  { id: 'pose', label: 'Pose' },
  { id: 'animate', label: 'Animate', isTimeline: true },
  { id: 'deform', label: 'Deform' },
];
