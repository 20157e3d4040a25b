import { loadPart } from '../core/failure.ts';
import type { DialogId } from './editor.ts';
import type { SectionComponent } from './sections.ts';

/** The content of a dialog. To add one, write a file and add a row below. */
export interface DialogEntry {
  /** The heading. */
  readonly title: string;
  readonly load: () => Promise<SectionComponent>;
}

/** Every dialog; only one is open at a time. Each is loaded when it first opens. */
export const dialogs: Readonly<Record<DialogId, DialogEntry>> = {
  keys: {
    title: 'Keys and pointer',
    load: async () => (await loadPart(import('./panels/help-sheet.tsx'))).HelpSheet,
  },
};
