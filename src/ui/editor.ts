import type { ReadonlySignal, Signal } from '@preact/signals-core';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { FileEntry } from '../formats/format.ts';
import type { PictureFormat } from '../view/picture.ts';
import type { Verification, Viewer } from '../view/viewer.ts';
import type { Workspace, WorkspaceId } from './workspace.ts';

/** A character that comes with the app. */
export interface BundledCharacter {
  readonly id: string;
  readonly label: string;
  readonly credit: string;
}

/** What the interface shows and can ask for; put together in app. */
export interface Editor {
  readonly store: Store;
  readonly session: Session;
  readonly viewer: Viewer;
  readonly workspaces: readonly Workspace[];
  readonly workspaceId: ReadonlySignal<WorkspaceId>;
  readonly bundled: ReadonlySignal<readonly BundledCharacter[]>;
  /** Id of the bundled character that is open, or null. */
  readonly openedId: ReadonlySignal<string | null>;
  readonly verification: ReadonlySignal<Verification | null>;
  /** A word on what was just done, for the status line. */
  readonly notice: Signal<string>;
  readonly helpOpen: Signal<boolean>;
  /** Endings that the file dialog offers. */
  readonly fileExtensions: readonly string[];
  openFiles(files: readonly FileEntry[]): Promise<void>;
  openBundled(id: string): Promise<void>;
  setWorkspace(id: WorkspaceId): void;
  resetAll(): void;
  copyPose(): Promise<void>;
  savePose(): void;
  exportMesh(): void;
  savePicture(format: PictureFormat): Promise<void>;
  verify(): void;
}
