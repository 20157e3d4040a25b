import type { ClipParts } from '../../../../core/motion/clip-parts.ts';
import { toggled, united } from '../../../../core/motion/edit/selection.ts';
import { type KeySelection, noKeys } from '../../../../core/motion/key-selection.ts';
import type { Gesture } from '../../../../document/store.ts';
import { oneKey } from '../../../curve-editor/curve-edits.ts';
import type { CurveModel } from '../../../curve-editor/curve-model.ts';
import { type Hit, hitAt, isSelected, keysInBox } from '../../../curve-editor/hits.ts';
import {
  type Drag,
  type DragStart,
  movingKeys,
  scalingKeys,
  turningHandle,
} from '../../../curve-editor/key-drags.ts';
import { type Place, placeIn } from '../../../curve-editor/plot.ts';
import type { Editor } from '../../../editor.ts';
import { EdgeScroll } from '../../../timeline/edge-scroll.ts';
import type { PlotView } from './plot-view.ts';
import { pan } from './plot-window.ts';

/** How far the pointer goes before a press becomes a drag, in pixels; a finger is less steady. */
const [leastDrag, leastTouchDrag] = [3, 8];
/** From how far a key or a handle is met, in pixels. */
const [reach, touchReach] = [7, 22];
const longPress = 500; // milliseconds

/** A press of the pointer on the plot, until it is released. */
interface Press {
  readonly id: number;
  readonly from: Place;
  readonly hit: Hit;
  readonly isTouch: boolean;
  readonly shift: boolean;
  /** What it does, once it has become a drag. */
  act: Act | null;
  /** Where the pointer was last. */
  last: PointerEvent;
}

interface Act {
  move(to: Place, event: PointerEvent): void;
  end(): void;
  cancel(): void;
}

/** Lets the pointer select, move, scale and turn in the plot; returns what ends it. */
export function listenToPlot(view: PlotView): () => void {
  const { canvas, model, editor } = view;
  let press: Press | null = null;
  let timer = 0;
  const placeOf = ({ clientX, clientY }: MouseEvent): Place => {
    const { left, top } = canvas.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  };
  const act = (): void => press?.act?.move(placeOf(press.last), press.last);
  const edges = new EdgeScroll({
    size: () => view.shown().plot,
    scroll: (across, down) => pan(view, view.shown().plot, { x: -across, y: -down }),
    again: act,
  });
  const stop = (): void => {
    press = null;
    window.clearTimeout(timer);
    edges.end();
    window.removeEventListener('keydown', onKey, true);
  };
  const cancel = (): void => {
    press?.act?.cancel();
    stop();
  };
  const onKey = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || !press?.act) return;
    event.preventDefault();
    event.stopPropagation();
    cancel();
  };

  const onDown = (event: PointerEvent): void => {
    if (event.button !== 0 || event.ctrlKey) return;
    if (!event.isPrimary) {
      // A second finger moves the window; see plot-window.ts.
      cancel();
      return;
    }
    const isTouch = event.pointerType === 'touch';
    const from = placeOf(event);
    const hit = hitAt(view.shown(), from, isTouch ? touchReach : reach);
    const { pointerId: id, shiftKey: shift } = event;
    press = { id, from, hit, isTouch, shift, act: null, last: event };
    canvas.setPointerCapture(event.pointerId);
    window.addEventListener('keydown', onKey, true);
    choose(editor, model, press);
    window.clearTimeout(timer);
    if (!isTouch) return;
    timer = window.setTimeout(() => {
      if (press?.id !== id || press.act) return;
      stop();
      view.openMenu(event.clientX, event.clientY, true);
    }, longPress);
  };
  /** Opens the menu of what is under the pointer, or of all that is selected if that is part of it. */
  const onMenu = (event: MouseEvent): void => {
    event.preventDefault();
    // A long press opened it already.
    if (event instanceof PointerEvent && event.pointerType === 'touch') return;
    const hit = hitAt(view.shown(), placeOf(event), reach);
    choose(editor, model, { hit, shift: false });
    view.openMenu(event.clientX, event.clientY, false);
  };
  const onMove = (event: PointerEvent): void => {
    const to = placeOf(event);
    if (!press || event.pointerId !== press.id) {
      if (event.buttons === 0) canvas.style.cursor = cursorOver(hitAt(view.shown(), to, reach));
      return;
    }
    const far = Math.hypot(to.x - press.from.x, to.y - press.from.y);
    if (!press.act && far < (press.isTouch ? leastTouchDrag : leastDrag)) return;
    press.act ??= actOf(view, press);
    press.last = event;
    act();
    edges.moveTo(to.x, to.y);
  };
  const onUp = (event: PointerEvent): void => {
    if (!press || event.pointerId !== press.id) return;
    if (press.act) press.act.end();
    else click(editor, model, press);
    stop();
  };
  canvas.addEventListener('pointerdown', onDown);
  canvas.addEventListener('pointermove', onMove);
  canvas.addEventListener('pointerup', onUp);
  canvas.addEventListener('pointercancel', cancel);
  canvas.addEventListener('contextmenu', onMenu);
  return cancel;
}

/** Selects what is pressed, unless it is selected already and may be dragged with the others. */
function choose(
  { session }: Editor,
  model: CurveModel,
  { hit, shift }: Pick<Press, 'hit' | 'shift'>,
): void {
  if (hit.of !== 'nothing') model.fieldsAt.value = null;
  if (hit.of === 'line' || hit.of === 'key') model.chosen.value = hit.line.key;
  if (hit.of !== 'key') return;
  const key = oneKey(hit.line.key, hit.line.times[hit.at]!);
  const selection = session.selectedKeys.peek();
  if (shift) session.selectedKeys.value = toggled(selection, key);
  else if (!isSelected(selection, hit)) session.selectedKeys.value = key;
}

function click({ session }: Editor, model: CurveModel, { hit, shift, from }: Press): void {
  if (hit.of === 'key' && !shift) {
    session.selectedKeys.value = oneKey(hit.line.key, hit.line.times[hit.at]!);
    model.fieldsAt.value = from;
  }
  if ((hit.of === 'nothing' || hit.of === 'line') && !shift) {
    session.selectedKeys.value = noKeys;
    model.fieldsAt.value = null;
  }
}

function actOf(view: PlotView, press: Press): Act {
  const { hit } = press;
  const drag = dragOf(view, press.from, hit);
  if (drag) return keyAct(view, drag);
  return boxAct(view, press);
}

function dragOf({ model, editor, shown }: PlotView, from: Place, hit: Hit): Drag | null {
  if (hit.of === 'nothing' || hit.of === 'line') return null;
  const { session } = editor;
  const fps = model.shown.peek()?.parts.fps ?? 30;
  const start: DragStart = {
    from,
    plot: shown().plot,
    selection: model.selection.peek(),
    scales: model.scales.peek(),
    fps,
    snaps: session.snapsToFrames.peek(),
  };
  if (hit.of === 'box') return scalingKeys(start, hit.box, hit.handle);
  const line = hit.of === 'handle' ? hit.handle.line : hit.line;
  const unit = model.unitOf(line.key);
  if (hit.of === 'key') return movingKeys(start, hit, unit);
  return turningHandle(start, hit.handle, model.breaksHandles.peek(), unit);
}

/** Edits keys as one gesture, which shows its result while it goes on. */
function keyAct({ model, editor, shown }: PlotView, drag: Drag): Act {
  const { session, store } = editor;
  const before = session.selectedKeys.peek();
  const clip = model.shown.peek()?.parts;
  const { plot } = shown();
  model.bind();
  model.hold();
  let gesture: Gesture | null = null;
  const restore = (): void => {
    session.selectedKeys.value = before;
    model.release();
  };
  return {
    move(to, event) {
      if (!clip || gesture?.isOpen === false) return;
      // The plot may have scrolled since the drag began.
      const place = placeIn(plot, shown().plot, to);
      const { label, telling, edit } = drag(place, { shift: event.shiftKey, alt: event.altKey });
      const { clip: edited, selection } = edit(clip);
      const made = model.editOf(label, (now): ClipParts => (edited === clip ? now : edited));
      if (!made) return;
      gesture ??= store.begin(label);
      gesture.preview(made);
      session.selectedKeys.value = merged(before, selection);
      model.telling.value = telling;
    },
    end() {
      if (gesture?.isOpen === false) restore();
      else gesture?.commit();
      model.release();
    },
    cancel() {
      gesture?.cancel();
      restore();
    },
  };
}

/** The selection with its edited channels at their new times; channels out of sight stay. */
function merged(before: KeySelection, edited: KeySelection): KeySelection {
  return new Map([...before, ...edited]);
}

/** Selects the keys in a rectangle; with Shift, in addition to the selected ones. */
function boxAct({ editor, model, shown, chosenBox }: PlotView, { from, shift }: Press): Act {
  const { session } = editor;
  const before = session.selectedKeys.peek();
  const { plot } = shown();
  return {
    move(to) {
      const start = placeIn(shown().plot, plot, from);
      const box = {
        left: Math.min(start.x, to.x),
        right: Math.max(start.x, to.x),
        top: Math.min(start.y, to.y),
        bottom: Math.max(start.y, to.y),
      };
      chosenBox.value = box;
      const found = keysInBox(shown(), box);
      session.selectedKeys.value = shift ? united(before, found) : found;
      model.fieldsAt.value = null;
    },
    end() {
      chosenBox.value = null;
    },
    cancel() {
      chosenBox.value = null;
      session.selectedKeys.value = before;
    },
  };
}

function cursorOver(hit: Hit): string {
  if (hit.of === 'key') return 'move';
  if (hit.of === 'handle') return 'grab';
  if (hit.of === 'line') return 'pointer';
  if (hit.of === 'nothing') return 'crosshair';
  const { across, down } = hit.handle;
  if (across === 0) return 'ns-resize';
  if (down === 0) return 'ew-resize';
  return across === down ? 'nwse-resize' : 'nesw-resize';
}
