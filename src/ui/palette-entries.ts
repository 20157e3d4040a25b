import { printable } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import type { Extrapolation } from '../core/motion/clip-parts.ts';
import { setMethod } from '../document/edits.ts';
import { setEnvironment } from '../document/environment-edits.ts';
import { lightPresets } from '../document/light-presets.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { SavedPose } from '../document/saved-poses.ts';
import { aspects } from '../document/shots.ts';
import { methods } from '../skinning/registry.ts';
import { attempt } from './attempt.ts';
import { type Command, keyName, runCommand } from './commands/command.ts';
import { contexts } from './commands/contexts.ts';
import { commandGroups } from './commands/registry.ts';
import { continueCurves, continuedCurves, extrapolations } from './curve-editor/continue-curves.ts';
import type { Editor } from './editor.ts';
import { numberedNames } from './numbered-names.ts';
import { otherPoseFormats } from './pose-files.ts';
import { keyOf } from './saved-poses.ts';
import type { Findable } from './rank-entries.ts';
import { goToShot, setAspect, shownShot } from './shots.ts';
import { tabs } from './tabs.ts';
import { influenceCounts, keepStrongest } from './weights.ts';

/** A row of the command palette. */
export interface PaletteEntry extends Findable {
  /** The heading under which it stands while nothing is typed. */
  readonly group: string;
  /** The name of its first key. */
  readonly key?: string;
  /** For a toggle: whether it is on. */
  readonly isOn?: boolean;
  readonly run: () => void;
}

/** Everything that can be done now, in the order of the palette while nothing is typed. */
export function paletteEntries(editor: Editor): readonly PaletteEntry[] {
  return [
    ...commandGroups.flatMap(({ label: group, commands }) =>
      commands.filter((command) => applies(command, editor)).map(toEntry(group, editor)),
    ),
    ...tabEntries(editor),
    ...workspaceEntries(editor),
    ...curveEntries(editor),
    ...methodEntries(editor),
    ...characterEntries(editor),
    ...actorEntries(editor),
    ...poseFileEntries(editor),
    ...poseEntries(editor),
    ...sceneEntries(editor),
    ...lightEntries(editor),
    ...shotEntries(editor),
    ...weightEntries(editor),
    ...jointEntries(editor),
  ];
}

/**
 * Whether a command can do something now. The timeline's commands need only a clip, and those for
 * the whole character may deselect its joint.
 */
function applies(command: Command, editor: Editor): boolean {
  if (command.keyOnly || command.isEnabled?.(editor) === false) return false;
  const { context = 'everywhere' } = command;
  if (context === 'timeline' || context === 'character') return true;
  return contexts.find(({ id }) => id === context)?.isActive(editor) === true;
}

function toEntry(group: string, editor: Editor): (command: Command) => PaletteEntry {
  return (command) => {
    const { id, label, keys, isOn } = command;
    const run = (): void => runCommand(command, editor);
    return {
      ...{ id, label, group, isCommand: true, run },
      ...(keys?.[0] && { key: keyName(keys[0]) }),
      ...(isOn && { isOn: isOn(editor) }),
    };
  };
}

function tabEntries(editor: Editor): PaletteEntry[] {
  return tabs.map(({ id, label }) =>
    dataEntry('Tabs', `tab ${id}`, `${label} tab`, () => (editor.tab.value = id)),
  );
}

function workspaceEntries(editor: Editor): PaletteEntry[] {
  return editor.workspaces.map(({ id, label }) =>
    dataEntry('Looks', `look ${id}`, `${label} look`, () => editor.setWorkspace(id)),
  );
}

/** How the curves of the selected keys, or the chosen curve, go on at each end. */
function curveEntries(editor: Editor): PaletteEntry[] {
  if (continuedCurves(editor).length === 0) return [];
  return (['before', 'after'] as const).flatMap((end) =>
    (Object.keys(extrapolations) as Extrapolation[]).map((rule) =>
      dataEntry(
        'Curves',
        `continue ${end} ${rule}`,
        `Continue the curves ${end} their keys: ${extrapolations[rule]}`,
        () => continueCurves(editor, end, rule),
      ),
    ),
  );
}

function methodEntries({ store, session }: Editor): PaletteEntry[] {
  const actor = selectedActor(store, session);
  if (!actor) return [];
  return methods.map(({ id, label }) =>
    dataEntry('Methods', `method ${id}`, `Method: ${label}`, () =>
      store.dispatch(setMethod(actor.id, id)),
    ),
  );
}

function characterEntries(editor: Editor): PaletteEntry[] {
  return editor.bundled.value.flatMap(({ id, label }) => [
    dataEntry('Characters', `open ${id}`, `Open ${label}`, () =>
      attempt(editor, editor.openBundled(id)),
    ),
    dataEntry('Characters', `add ${id}`, `Add ${label}`, () =>
      attempt(editor, editor.openBundled(id, true)),
    ),
  ]);
}

/** What selects each character of a scene that has several. */
function actorEntries(editor: Editor): PaletteEntry[] {
  const { actors } = editor.store.scene.value;
  if (actors.length < 2) return [];
  const names = numberedNames(actors.map(({ name }) => name));
  return actors.map(({ id }, index) =>
    dataEntry('Characters', `actor ${id}`, `Select the character ${names[index]!}`, () =>
      editor.select(id),
    ),
  );
}

function poseFileEntries(editor: Editor): PaletteEntry[] {
  return otherPoseFormats(editor).map((format) =>
    dataEntry('Files', `save pose ${format.id}`, `Save the pose as ${format.label}`, () =>
      attempt(editor, editor.savePose(format)),
    ),
  );
}

/** What applies each pose of the library. */
function poseEntries(editor: Editor): PaletteEntry[] {
  if (!selectedActor(editor.store, editor.session)) return [];
  return editor.store.scene.value.poses.map((pose) =>
    dataEntry('Poses', `pose ${pose.id}`, `Pose: ${printable(pose.name, 80)}`, () =>
      attempt(editor, applySaved(editor, pose)),
    ),
  );
}

async function applySaved(editor: Editor, pose: SavedPose): Promise<void> {
  const { poseLibraryOf } = await loadPart(import('./pose-library.ts'));
  poseLibraryOf(editor).apply({ key: keyOf(pose), name: pose.name, pose, saved: pose });
}

function sceneEntries(editor: Editor): PaletteEntry[] {
  return editor.scenes.map(({ id, label }) =>
    dataEntry('Scenes', `scene ${id}`, `Open ${label}`, () =>
      attempt(editor, editor.openBundledScene(id)),
    ),
  );
}

function lightEntries({ store }: Editor): PaletteEntry[] {
  return lightPresets.map(({ id, label, environment }) =>
    dataEntry('Light', `light ${id}`, `Light: ${label}`, () =>
      store.dispatch(setEnvironment(environment, `Light: ${label}`)),
    ),
  );
}

function shotEntries(editor: Editor): PaletteEntry[] {
  const goes = editor.store.scene.value.shots.map((shot) =>
    dataEntry('Shots', `shot ${shot.id}`, `Go to ${printable(shot.name, 80)}`, () => {
      goToShot(editor, shot);
    }),
  );
  if (!shownShot(editor)) return goes;
  const forms = aspects.map(({ id, label }) =>
    dataEntry('Shots', `aspect ${id}`, `Aspect of the shot: ${label}`, () => setAspect(editor, id)),
  );
  return [...goes, ...forms];
}

function weightEntries(editor: Editor): PaletteEntry[] {
  const actor = selectedActor(editor.store, editor.session);
  if (!actor || actor.character.mesh.pointCount === 0) return [];
  return Object.entries(influenceCounts).map(([label, count]) =>
    dataEntry('Weights', `influences ${label}`, `Keep influences: ${label}`, () =>
      keepStrongest(editor, count),
    ),
  );
}

function jointEntries(editor: Editor): PaletteEntry[] {
  const names = selectedActor(editor.store, editor.session)?.character.skeleton.names ?? [];
  return names.map((name, joint) =>
    dataEntry('Joint', `joint ${name}`, `Select ${printable(name, 80)}`, () =>
      editor.editJoint(joint),
    ),
  );
}

function dataEntry(group: string, id: string, label: string, run: () => void): PaletteEntry {
  return { id, label, group, isCommand: false, run };
}
