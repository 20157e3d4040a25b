import { type Signal, batch } from '@preact/signals-core';
import { type Camera, startCamera } from './camera.ts';
import { selectActor } from './reconcile.ts';
import type { Scene } from './scene.ts';
import { Session } from './session.ts';
import { shotById } from './shots.ts';

type SignalName = {
  [Key in keyof Session]: Session[Key] extends Signal ? Key : never;
}[keyof Session];

/** The signals of the session that a saved view has. To save another switch, add its name. */
const savedSignals = [
  'showSkin',
  'showSkeleton',
  'skeletonStyle',
  'showAxes',
  'translucent',
  'showTextures',
  'showWeights',
  'weightView',
  'unlitWeights',
  'showNormals',
  'comparison',
  'shownShot',
  'showThirds',
  'posesBy',
  'clipIndex',
  'clipTime',
  'playMode',
  'playSpeed',
] as const satisfies readonly SignalName[];

/** Their values. */
export type SavedSignals = {
  readonly [Key in (typeof savedSignals)[number]]: Session[Key]['value'];
};

/** How a scene is viewed, as a value: what a picture of it depends on, and where work goes on. */
export interface ViewState {
  readonly camera: Camera;
  /** The id of the workspace. */
  readonly workspace: string;
  /** The selected actor: an index of the scene's actors. */
  readonly selected: number | null;
  /** The selected joint: its index in the character's file. */
  readonly joint: number | null;
  readonly signals: SavedSignals;
}

function signalsOf(session: Session): SavedSignals {
  const entries = savedSignals.map((name) => [name, session[name].value]);
  return Object.fromEntries(entries) as SavedSignals;
}

/** What a saved view has where it says nothing. */
export const plainView: ViewState = {
  camera: startCamera,
  workspace: 'studio',
  selected: null,
  joint: null,
  signals: signalsOf(new Session()),
};

/** Returns how the session views the scene. Reading subscribes to all of it. */
export function viewStateOf(
  { actors }: Scene,
  session: Session,
  camera: Camera,
  workspace: string,
): ViewState {
  const selected = actors.findIndex(({ id }) => id === session.selectedActorId.value);
  const joint = session.selectedJoint.value;
  const skeleton = actors[selected]?.character.skeleton;
  return {
    camera,
    workspace,
    selected: selected < 0 ? null : selected,
    joint: joint === null ? null : (skeleton?.sourceIndex[joint] ?? null),
    signals: signalsOf(session),
  };
}

/** Makes the session view the scene as a state says, as far as the scene has what it names. */
export function showView(
  scene: Scene,
  session: Session,
  { selected, joint, signals }: ViewState,
): void {
  batch(() => {
    for (const name of savedSignals) (session[name] as Signal<unknown>).value = signals[name];
    session.shownShot.value = shotById(scene, signals.shownShot)?.id ?? null;
    const actor = selected === null ? undefined : scene.actors[selected];
    if (!actor) return;
    selectActor(session, scene, actor.id);
    session.clipIndex.value = actor.clips[signals.clipIndex] ? signals.clipIndex : 0;
    session.selectedJoint.value =
      joint === null ? null : (actor.character.skeleton.jointOfSource[joint] ?? null);
  });
}
