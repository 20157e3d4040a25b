import type { Signal } from '@preact/signals-core';
import type { ReadCharacter } from '../../formats/read-characters.ts';
import type { Opening } from '../../ui/editor.ts';
import type { WorkspaceId } from '../../ui/workspace.ts';
import type { CatalogueEntry } from '../catalogue.ts';
import type { FileOpener } from '../open-files.ts';
import type { ProgressMeter } from '../progress-meter.ts';
import type { SceneTarget } from './scene-target.ts';

/** The parts of the page that saving and opening scenes needs. */
export interface SceneParts {
  readonly opening: Opening;
  readonly opener: FileOpener;
  /** The characters from the user's own files. */
  readonly own: Signal<readonly ReadCharacter[]>;
  readonly meter: ProgressMeter;
  readonly workspaceId: Signal<WorkspaceId>;
  readonly target: SceneTarget;
  /** The bundled character with an id. */
  readonly entryOf: (id: string) => CatalogueEntry | undefined;
}
