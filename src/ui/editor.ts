import type { ReadonlySignal, Signal } from '@preact/signals-core';
import type { BallAngles } from '../document/ball-angles.ts';
import type { ActorId } from '../document/scene.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { Transport } from '../document/transport.ts';
import type { Evaluations } from '../evaluation/evaluations.ts';
import type { ConvertTarget } from '../formats/registry.ts';
import type { FileEntry } from '../formats/format.ts';
import type { ReadCharacter } from '../formats/read-characters.ts';
import type { PictureFormat } from '../view/picture.ts';
import type { CaptureSize, Viewer } from '../view/viewer.ts';
import type { Workspace, WorkspaceId } from './workspace.ts';

/** A character that comes with the app. */
export interface BundledCharacter {
  readonly id: string;
  readonly label: string;
  readonly credit: string;
}

/** Light or dark as the system has it, or as the user wants. */
export type ThemeChoice = 'system' | 'light' | 'dark';

/** The panel that is out, where panels are drawers. */
export type Drawer = 'left' | 'right';

/** What is being read, and how far it is (0 to 1). */
export interface Progress {
  readonly label: string;
  readonly fraction: number;
}

export interface PictureOptions {
  readonly format: PictureFormat;
  /** Pixels; the view's size where absent. */
  readonly size?: CaptureSize;
  /** Floor and backdrop; without them a PNG is transparent. */
  readonly background: boolean;
  readonly target: 'file' | 'clipboard';
}

/** The scene, how it is looked at, and what is seen. */
export interface Looking {
  readonly store: Store;
  readonly session: Session;
  /** The scene as it is shown at the moment. */
  readonly evaluations: Evaluations;
  readonly viewer: Viewer;
}

/** A list that is there, or is being made. */
type Listed<T> = readonly T[] | Promise<readonly T[]>;

/** Where characters come from. */
export interface Gallery {
  readonly bundled: ReadonlySignal<readonly BundledCharacter[]>;
  /** Characters of the user's own files, those opened last at the end; earlier ones stay. */
  readonly own: ReadonlySignal<readonly ReadCharacter[]>;
  /** Id of the bundled character that is selected, or null. */
  readonly openedId: ReadonlySignal<string | null>;
  /** Shown for work that takes more than a moment. */
  readonly progress: ReadonlySignal<Progress | null>;
  /**
   * Takes over from what is being opened at once, also while the files themselves are still being listed.
   *
   * @param add beside the others; else in the place of the selected one
   */
  openFiles(files: Listed<FileEntry>, add?: boolean): Promise<void>;
  openBundled(id: string, add?: boolean): Promise<void>;
  openOwn(character: ReadCharacter, add?: boolean): void;
  cancelOpening(): void;
  /** Settles when nothing is being opened. */
  whenOpened(): Promise<void>;
}

/** Ways of working. */
export interface Courses {
  readonly workspaces: readonly Workspace[];
  readonly workspaceId: ReadonlySignal<WorkspaceId>;
  setWorkspace(id: WorkspaceId): void;
  /** Frames what came into the scene, where the workspace does so. */
  frameOpened(): void;
}

/** What the page tells. */
export interface Telling {
  /** A word on what was just done, for the status line. */
  readonly notice: Signal<string>;
}

/** How the page itself is, apart from the scene. */
export interface PageState {
  readonly theme: Signal<ThemeChoice>;
  readonly helpOpen: Signal<boolean>;
  /** Whether single letters act; speech input and cats may want them off. */
  readonly letterKeys: Signal<boolean>;
  readonly drawer: Signal<Drawer | null>;
  /** Endings that the file dialog offers. */
  readonly fileExtensions: readonly string[];
}

/** What shows and plays poses. */
export interface Posing {
  readonly transport: Transport;
  /** By which balls are shown. */
  readonly ballAngles: BallAngles;
}

/** What a user can do with the selected character, beside edits of single values. */
export interface Actions {
  /** Selects an actor of the scene. */
  select(id: ActorId): void;
  removeSelected(): void;
  /** Adds a copy of the selected actor, as it is posed, beside the others. */
  duplicateSelected(): void;
  resetAll(): void;
  /** Selects a joint and takes the keyboard to its first slider. */
  editJoint(joint: number): void;
  copyPose(): Promise<void>;
  savePose(): void;
  /** Saves the character in a course's format, converted as far as it can hold it. */
  saveAs(format: ConvertTarget): Promise<void>;
  exportMesh(): Promise<void>;
  savePicture(options: PictureOptions): Promise<void>;
  verify(): Promise<void>;
}

/** What opens characters: all that a page needs before its panels are there. */
export type Opening = Looking & Gallery & Courses & Telling & Pick<PageState, 'theme'>;

/** All of it, put together in app; each panel asks for the parts that it needs. */
export type Editor = Opening & PageState & Posing & Actions;
