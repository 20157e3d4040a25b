import type { ReadonlySignal, Signal } from '@preact/signals-core';
import type { Character } from '../core/character.ts';
import type { BallAngles } from '../document/ball-angles.ts';
import type { PlaceAngles } from '../document/place-angles.ts';
import type { ActorId } from '../document/scene.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { Transport } from '../document/transport.ts';
import type {
  MeasurementInput,
  MeasurementKind,
  MeasurementResult,
} from '../evaluation/comparison/measurement.ts';
import type { Evaluations } from '../evaluation/evaluations.ts';
import type { PrepareControl } from '../evaluation/preparation.ts';
import type { ConvertTarget, FormatId } from '../formats/registry.ts';
import type { FileEntry } from '../formats/format.ts';
import type { PoseFormat } from '../formats/pose-formats.ts';
import type { NamedPose } from '../posing/named-pose.ts';
import type { ReadCharacter, ReadProgress } from '../formats/read-characters.ts';
import type { MoviePlan } from '../view/movie/movie-plan.ts';
import type { MovieFormatId, MovieSettings } from '../view/movie/movie-settings.ts';
import type { PictureSettings } from '../view/picture/picture-size.ts';
import type { Viewer } from '../view/viewer.ts';
import type { Hint } from './hints.ts';
import type { TabId } from './tabs.ts';
import type { Workspace, WorkspaceId } from './workspace.ts';

/** A character that is bundled with the app. */
export interface BundledCharacter {
  readonly id: string;
  readonly label: string;
  /** The course whose files it is in. */
  readonly course: FormatId;
  readonly credit: string;
  /**
   * The list of its poses, a JSON in the folder `data`, beside which a picture of the same name shows
   * them in a row; absent if it has none.
   */
  readonly poses?: string;
}

/** A pose that comes with a bundled character. */
export interface BundledPose {
  readonly name: string;
  readonly pose: NamedPose;
}

/** Bundled characters that belong together. */
export interface BundledScene {
  readonly id: string;
  readonly label: string;
}

/** The theme: the system's, or the user's choice. */
export type ThemeChoice = 'system' | 'light' | 'dark';

/** A sheet over the page; dialogs.ts has the contents. */
export type DialogId =
  | 'arrival'
  | 'gallery'
  | 'keys'
  | 'long link'
  | 'methods'
  | 'movie'
  | 'palette'
  | 'wanted';

/** The panel that is open on narrow pages: a sheet on phones; on tablets, the unfolded outliner. */
export type Drawer = 'left' | 'right';

/** The current activity of reading, and the fraction that is done (0 to 1). */
export interface Progress {
  readonly label: string;
  readonly fraction: number;
}

/** Where a picture goes; with its passes it is in an archive. */
export type PictureTarget = 'file' | 'clipboard' | 'passes';

/** A form in which movies are saved. */
export interface MovieChoice {
  readonly id: MovieFormatId;
  readonly label: string;
  /** Whether frames may be transparent. */
  readonly isTransparent: boolean;
  /** The reason why this browser can't save it, or null if it can. */
  readonly whyNot: string | null;
  /** About how large the file will be. */
  readonly bytes: number;
}

/** The scene and the state of the view. */
export interface Looking {
  readonly store: Store;
  readonly session: Session;
  /** The computed state of the scene as it is shown now. */
  readonly evaluations: Evaluations;
  readonly viewer: Viewer;
}

/** A list, or a promise of one. */
type Listed<T> = readonly T[] | Promise<readonly T[]>;

/** The question whether opened characters replace the selected one or are added beside it. */
export interface ArrivalQuestion {
  /** The name of what came. */
  readonly name: string;
  /** The name of the selected character. */
  readonly replaced: string;
  /** Only the first answer counts; null opens nothing. */
  answer(add: boolean | null): void;
}

/** The files without which some characters of a scene are missing. */
export interface WantedFiles {
  /** The name of the scene. */
  readonly scene: string;
  readonly files: readonly string[];
  /** Completes the scene by files, and returns whether any of them belongs to it. */
  give(files: readonly FileEntry[], signal: AbortSignal): Promise<boolean>;
}

/** Files that were opened lately. */
export interface RecentFiles {
  readonly name: string;
  /** By which the browser finds them again; none where it gives no handles, or for chosen files. */
  readonly handles: readonly FileSystemHandle[];
}

/** The sources of characters. */
export interface Gallery {
  readonly bundled: ReadonlySignal<readonly BundledCharacter[]>;
  /** Characters from the user's own files, the last opened at the end; earlier ones stay. */
  readonly own: ReadonlySignal<readonly ReadCharacter[]>;
  /**
   * Replaces a running opening at once, even while the new files are still being listed.
   *
   * @param add keeps the other characters; otherwise the selected one is replaced, or all of an
   *   untouched scene; 'ask' asks the user where there is a choice
   * @param handles by which the browser finds the files again
   */
  openFiles(
    files: Listed<FileEntry>,
    add?: boolean | 'ask',
    handles?: Listed<FileSystemHandle>,
  ): Promise<void>;
  openBundled(id: string, add?: boolean): Promise<void>;
  openOwn(character: ReadCharacter, add?: boolean): void;
  /** What the arrival dialog asks, or null. */
  readonly question: Signal<ArrivalQuestion | null>;
  /** The files that an opened scene still needs, or null. */
  readonly wanted: Signal<WantedFiles | null>;
}

/** Work that can take longer than a moment, such as opening files. Only one runs at a time. */
export interface Working {
  /** Shown during work that takes longer than a moment. */
  readonly progress: ReadonlySignal<Progress | null>;
  /**
   * Cancels the work in progress and starts another. Returns its result, or undefined if it was
   * canceled or failed. A failure is reported, and the page stays as it was.
   */
  whileWorking<T>(
    title: string,
    work: (signal: AbortSignal, onProgress: ReadProgress) => Promise<T>,
  ): Promise<T | undefined>;
  cancelWork(): void;
  /** Resolves when no work is in progress. */
  whenDone(): Promise<void>;
}

/** The workspaces. */
export interface Courses {
  readonly workspaces: readonly Workspace[];
  readonly workspaceId: ReadonlySignal<WorkspaceId>;
  /** Shows the page as a workspace does, and draws the selected character so. */
  setWorkspace(id: WorkspaceId): void;
  /** Moves the camera to the workspace's position. */
  resetCamera(): void;
  /** Frames the new characters of the scene, if the workspace does that. */
  frameOpened(): void;
}

/** The messages of the page. */
export interface Telling {
  /** A short message about the last action, for the status line. */
  readonly notice: Signal<string>;
  /** The message that a scene came back; while it is shown, a fresh start is offered. */
  readonly restored: Signal<string>;
}

/**
 * Whether this browser has the scene as it is now: there is nothing to keep, it will have it in a
 * moment, it has it, or it can't keep it.
 */
export type Keeping = 'nothing' | 'soon' | 'kept' | 'failed';

/** A scene that this browser kept of an earlier visit or another tab. */
export interface EarlierScene {
  readonly id: string;
  readonly name: string;
  /** In milliseconds since 1970. */
  readonly time: number;
}

/** The state of the page itself, apart from the scene. */
export interface PageState {
  readonly theme: Signal<ThemeChoice>;
  /** The dialog that is open, or null. */
  readonly dialog: Signal<DialogId | null>;
  /** How pictures are saved, by `j` too. */
  readonly picture: Signal<PictureSettings>;
  /** How movies are saved. */
  readonly movie: Signal<MovieSettings>;
  /** The ids of the palette's entries that were used in this session, the last first. */
  readonly recentEntries: Signal<readonly string[]>;
  /** Whether the list of steps is open. */
  readonly showsHistory: Signal<boolean>;
  /** Whether the rotation lab is open. */
  readonly showsRotationLab: Signal<boolean>;
  /** Whether single-letter keys act; users of speech input, for example, may turn them off. */
  readonly letterKeys: Signal<boolean>;
  readonly tab: Signal<TabId>;
  /** What this visitor may not know yet. */
  readonly hints: ReadonlySignal<readonly Hint[]>;
  readonly drawer: Signal<Drawer | null>;
  /** The actor whose name is being written in the outliner, or null. */
  readonly renaming: Signal<ActorId | null>;
  readonly keeping: ReadonlySignal<Keeping>;
  /** The file extensions that the file dialog offers. */
  readonly fileExtensions: readonly string[];
}

/** The parts that show and play poses. */
export interface Posing {
  readonly transport: Transport;
  /** The angles at which ball joints are shown. */
  readonly ballAngles: BallAngles;
  /** The angles at which the rotations of whole characters are shown. */
  readonly placeAngles: PlaceAngles;
}

/** The files that a motion is saved in: MOTION.json, or CSE169's `.anim`. */
export type MotionForm = 'json' | 'anim';

/** What a user can do with the selected character, apart from editing single values. */
export interface Actions {
  readonly scenes: readonly BundledScene[];
  /** Opens a bundled scene in place of all characters, as one step of undo. */
  openBundledScene(id: string): Promise<void>;
  /**
   * Adds a bundled character beside the others, or in place of an untouched scene. Unlike other
   * openings it waits for those in progress, so that several can be added at once.
   */
  addBundled(id: string): Promise<void>;
  /** What was opened lately in this browser, the last first. */
  listRecent(): Promise<readonly RecentFiles[]>;
  /** Adds what was opened lately, by its handles. */
  openRecent(recent: RecentFiles): Promise<void>;
  forgetRecent(): Promise<void>;
  /** The scenes that this browser keeps and no page has open, the last changed first. */
  listEarlier(): Promise<readonly EarlierScene[]>;
  openEarlier(id: string): Promise<void>;
  /** Opens the first scene, beside which what was open is kept. */
  startFresh(): Promise<void>;
  /** Selects an actor of the scene. */
  select(id: ActorId): void;
  /** Removes all characters, as one step of undo. */
  clearScene(): void;
  removeSelected(): void;
  /** Adds a copy of the selected actor, in the same pose, next to the others. */
  duplicateSelected(): void;
  resetAll(): void;
  /** Selects a joint and moves the keyboard focus to its first slider. */
  editJoint(joint: number): void;
  /** The poses that come with a bundled character; none if it has no list of them. */
  bundledPoses(id: string, character: Character): Promise<readonly BundledPose[]>;
  /** Saves the pose that the selected character shows; as POSE.json, if no other form is given. */
  savePose(format?: PoseFormat): Promise<void>;
  /** Saves the bound clip of the selected character, or the one that Play would bind. */
  saveMotion(form: MotionForm): Promise<void>;
  /** Saves the character in a course's format, converted as far as that format allows. */
  saveAs(format: ConvertTarget): Promise<void>;
  exportMesh(): Promise<void>;
  /** Measures what methods do, on another thread; undefined if the signal ended it. */
  measure<Kind extends MeasurementKind>(
    input: MeasurementInput<Kind>,
    control: PrepareControl,
  ): Promise<MeasurementResult<Kind> | undefined>;
  /** Saves the numbers of the comparison that is shown, as CSV. */
  saveComparison(): Promise<void>;
  /**
   * Saves the scene with its files.
   *
   * @param asNew asks for a file even if the scene was saved in one before
   */
  saveScene(asNew: boolean): Promise<void>;
  /** Copies a link that opens the scene as it is viewed now, or offers the file in its place. */
  copyLink(): Promise<void>;
  savePicture(target: PictureTarget): Promise<void>;
  /** Makes a movie by the settings, frame by frame, and saves it. */
  saveMovie(): Promise<void>;
  /** All forms in which a movie may be saved. */
  movieChoices(plan: MoviePlan): Promise<readonly MovieChoice[]>;
  verify(): Promise<void>;
  /** Measures this machine with a bundled character and saves a report. */
  checkMachine(): Promise<void>;
}

/** The parts that open characters: all that the page needs before its panels are loaded. */
export type Opening = Looking &
  Gallery &
  Working &
  Courses &
  Telling &
  Pick<PageState, 'theme' | 'dialog'>;

/** All parts, assembled in src/app. Each panel declares only those that it needs. */
export type Editor = Opening & PageState & Posing & Actions;
