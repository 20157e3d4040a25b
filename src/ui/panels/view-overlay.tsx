import { useEffect, useState } from 'preact/hooks';
import { printable } from '../../core/diagnostics.ts';
import { loadPart } from '../../core/failure.ts';
import { actorById } from '../../document/scene.ts';
import type { ActiveDof } from '../../document/session.ts';
import { axisViewOf } from '../../view/axis-views.ts';
import { lightOfHandle } from '../../view/light-handles.ts';
import { pinHandles } from '../../view/pin-handles.ts';
import { ancestorsOf } from '../joint-rows.ts';
import { formatSize } from '../number-text.ts';
import { formatDegrees } from '../angle-text.ts';
import type { Editor, Looking, Posing } from '../editor.ts';
import { gimbalText } from '../gimbal-text.ts';
import { hintAt } from '../hints.ts';
import { preparing } from '../preparing.ts';
import type { SectionComponent } from '../sections.ts';
import { CommandButton } from './command-button.tsx';
import { ShotOverlay } from './shot-overlay.tsx';
import { Loaded } from './loaded.tsx';
import { PreparingBox } from './preparing-box.tsx';
import { ViewControls } from './view-controls.tsx';

/** The number of ancestors that are named, the nearest ones. */
const longestChain = 4;

/**
 * Shown over the view: progress, the reason why there is no picture, and the buttons of the
 * drawers.
 */
export function ViewOverlay({ editor }: { readonly editor: Editor }) {
  return (
    <>
      {editor.session.comparison.value && <Loaded editor={editor} load={loadComparison} />}
      <ShotOverlay editor={editor} />
      <ViewControls editor={editor} />
      <ProgressBox editor={editor} />
      <PreparingBox editor={editor} />
      <ViewMessage editor={editor} />
      <CameraText editor={editor} />
      <ViewHint editor={editor} />
      <ActiveDofText editor={editor} />
      <GimbalText editor={editor} />
      <Spoken editor={editor} />
      <LightText editor={editor} />
      <PinText editor={editor} />
      <LitBoneLabel editor={editor} />
      {editor.session.autoKey.value && (
        <div class="recording">
          <span>Auto-key</span>
        </div>
      )}
      {editor.session.inspectedPoint.value !== null && (
        <Loaded editor={editor} load={loadInspection} />
      )}
      {editor.session.showWeights.value && <Loaded editor={editor} load={loadWeights} />}
    </>
  );
}

async function loadWeights(): Promise<SectionComponent> {
  return (await loadPart(import('./weights-overlay.tsx'))).WeightsOverlay;
}

async function loadInspection(): Promise<SectionComponent> {
  return (await loadPart(import('./vertex-inspector/inspection-overlay.tsx'))).InspectionOverlay;
}

async function loadComparison(): Promise<SectionComponent> {
  return (await loadPart(import('./deform-lab/comparison-overlay.tsx'))).ComparisonOverlay;
}

/** What a newcomer may try next in the view; it goes once that was done. */
function ViewHint({ editor }: { readonly editor: Editor }) {
  const { hints, store, session } = editor;
  const hint = hintAt(hints.value, 'view');
  const { activeDof, shownShot, showWeights, comparison } = session;
  const isBusy =
    activeDof.value !== null ||
    shownShot.value !== null ||
    showWeights.value ||
    comparison.value !== null;
  const isWaiting = preparing(editor).length > 0;
  const isQuiet =
    !isBusy && !isWaiting && gimbalText(editor) === '' && store.scene.value.actors.length > 0;
  return hint && isQuiet ? <p class="view-hint">{hint.text}</p> : null;
}

function ProgressBox({ editor }: { readonly editor: Editor }) {
  const progress = editor.progress.value;
  if (!progress) return null;
  return (
    <div class="progress" role="status">
      <label>
        {progress.label}
        <progress value={progress.fraction} max={1} />
      </label>
      <CommandButton editor={editor} command="cancel-work" />
    </div>
  );
}

/** Says that the view has no perspective, and along which axis it looks. */
function CameraText({ editor: { viewer } }: { readonly editor: Looking }) {
  const camera = viewer.camera.value;
  if (camera.projection === 'perspective') return null;
  const axis = axisViewOf(camera);
  return <p class="camera-text">{axis ? `${axis.label} · orthographic` : 'Orthographic'}</p>;
}

/**
 * What a drag of a handle has done so far, or else the degree of freedom that was last changed, with
 * its value, in a corner of the picture. It changes with every frame, so it is not read out.
 */
function ActiveDofText({ editor }: { readonly editor: Looking & Posing }) {
  const { dragText, activeDof } = editor.session;
  const dof = activeDof.value;
  const value = dof ? valueOf(editor, dof) : undefined;
  const text =
    dragText.value ??
    (dof && value !== undefined
      ? `${dof.name} ${value.toFixed(3)}${dof.isAngle ? ` (${formatDegrees(value)})` : ''}`
      : null);
  if (text === null) return null;
  return (
    <output class="active-dof" aria-live="off">
      {text}
    </output>
  );
}

/** Says where two angles turn about one axis. */
function GimbalText({ editor }: { readonly editor: Looking & Posing }) {
  const text = editor.session.posesBy.value === 'mode' ? '' : gimbalText(editor);
  return text === '' ? null : <p class="gimbal-text">{text}</p>;
}

/** Milliseconds after the last change until a value is read out. */
const restingTime = 400;

/** Says the joint and its angle, once it rests, to those who don't see it. */
function Spoken({ editor }: { readonly editor: Looking & Posing }) {
  const { dragText, activeDof } = editor.session;
  const dof = activeDof.value;
  const value = dof ? valueOf(editor, dof) : undefined;
  const number = value === undefined ? '' : dof?.isAngle ? formatDegrees(value) : value.toFixed(3);
  const text = dragText.value ?? (dof ? `${dof.name} ${number}` : '');
  const [spoken, setSpoken] = useState('');
  useEffect(() => {
    const timer = setTimeout(() => setSpoken(text), restingTime);
    return () => clearTimeout(timer);
  }, [text]);
  return (
    <p class="spoken" role="status">
      {spoken}
    </p>
  );
}

/** The light under the pointer, with its direction, in the same corner. */
function LightText({ editor: { session, store } }: { readonly editor: Looking }) {
  const index = lightOfHandle(session.hoveredHandle.value);
  const light = index === null ? undefined : store.scene.value.environment.lights[index];
  if (!light) return null;
  const { name, azimuth, elevation } = light;
  return (
    <output class="active-dof">
      {name} light {azimuth.toFixed(1)}° around, {elevation.toFixed(1)}° above
    </output>
  );
}

/** The pin under the pointer, in the same corner: what it holds, and how far it is from that. */
function PinText({ editor: { session, evaluations } }: { readonly editor: Looking }) {
  const id = session.hoveredHandle.value;
  const pins = id === null ? [] : evaluations.visible().flatMap(pinHandles);
  const handle = pins.find((each) => each.id === id);
  const shown = handle && evaluations.visible().find(({ state }) => state.id === handle.actorId);
  if (!shown) return null;
  return (
    <output class="active-dof">
      {printable(shown.state.character.skeleton.names[handle.joint]!, 40)}{' '}
      {handle.follows ? 'follows another character' : 'stays in its place'}
      {handle.miss > 0 && `, ${formatSize(handle.miss)} away from it`}
    </output>
  );
}

/** The highlighted bone's name and its ancestors, next to the pointer. */
function LitBoneLabel({ editor: { store, session } }: { readonly editor: Looking }) {
  const place = session.hoverPlace.value;
  const limb = session.hoveredLimb.value;
  const skeleton = actorById(store.scene.value, limb?.actorId ?? null)?.character.skeleton;
  // A vertex under the pointer has a table of its own, which names its joints.
  if (session.showWeights.value && session.hoveredPoint.value !== null) return null;
  if (!place || !limb || !skeleton || limb.joint >= skeleton.jointCount) return null;
  const { joint } = limb;
  const end = limb.bone?.child ?? -1;
  const chain = ancestorsOf(skeleton, joint).slice(0, longestChain).reverse();
  const nameOf = (each: number): string => printable(skeleton.names[each] ?? '', 40);
  return (
    <p class="lit-bone" style={{ left: `${place[0] + 14}px`, top: `${place[1] + 14}px` }}>
      <strong>
        {nameOf(joint)}
        {end >= 0 && ` → ${nameOf(end)}`}
      </strong>
      {chain.length > 0 && <span>{chain.map(nameOf).join(' › ')}</span>}
    </p>
  );
}

function valueOf(
  { evaluations, ballAngles }: Looking & Posing,
  { index, ballAxis }: ActiveDof,
): number | undefined {
  const shown = evaluations.selected();
  if (!shown || ballAxis === undefined) return shown?.poseToEdit.q[index];
  return ballAngles.of(shown.state.character.skeleton, shown.poseToEdit.q, index)[ballAxis];
}

function ViewMessage({ editor }: { readonly editor: Looking }) {
  const text = messageOf(editor);
  if (text === null) return null;
  return (
    <p class="message" role="alert">
      {text}
    </p>
  );
}

function messageOf({ viewer }: Looking): string | null {
  if (viewer.refusal.value !== null) {
    return (
      `This character can't be drawn here: ${viewer.refusal.value}. ` +
      'It can still be posed and exported, on the CPU.'
    );
  }
  if (viewer.available.value) return null;
  if (viewer.hadContext) {
    return (
      'The graphics context was lost, as happens when a driver restarts. Your pose is kept; the ' +
      'picture comes back by itself. If it does not in a few seconds, save the pose and reload.'
    );
  }
  return (
    'Sinew draws with WebGL2, which this browser does not offer here. Turn on hardware ' +
    'acceleration in its settings, or try a current Chrome, Edge, Firefox or Safari. Files can ' +
    'still be opened, posed and exported.'
  );
}
