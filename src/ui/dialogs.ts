import { loadPart } from '../core/failure.ts';
import type { DialogId } from './editor.ts';
import { CommandPalette } from './panels/command-palette.tsx';
import type { SectionComponent } from './sections.ts';

/** The content of a dialog. To add one, write a file and add a row below. */
export interface DialogEntry {
  /** The heading. */
  readonly title: string;
  readonly load: () => Promise<SectionComponent>;
}

/**
 * Every dialog; only one is open at a time. Each is loaded when it first opens, except for the
 * palette: what is typed at once must reach it.
 */
export const dialogs: Readonly<Record<DialogId, DialogEntry>> = {
  arrival: {
    title: 'Replace or add',
    load: async () => (await loadPart(import('./panels/arrival.tsx'))).Arrival,
  },
  gallery: {
    title: 'Add a character',
    load: async () => (await loadPart(import('./panels/gallery.tsx'))).Gallery,
  },
  keys: {
    title: 'Keys and pointer',
    load: async () => (await loadPart(import('./panels/help-sheet.tsx'))).HelpSheet,
  },
  'long link': {
    title: 'Save a file instead',
    load: async () => (await loadPart(import('./panels/long-link.tsx'))).LongLink,
  },
  methods: {
    title: 'Skinning methods',
    load: async () => (await loadPart(import('./panels/method-help/method-help.tsx'))).MethodHelp,
  },
  movie: {
    title: 'Save a movie',
    load: async () => (await loadPart(import('./panels/movie-dialog.tsx'))).MovieDialog,
  },
  wanted: {
    title: 'Files of the scene',
    load: async () => (await loadPart(import('./panels/wanted.tsx'))).Wanted,
  },
  palette: {
    title: 'Commands',
    load: () => Promise.resolve(CommandPalette),
  },
};
