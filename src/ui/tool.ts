import type { PickPlace } from '../view/pick.ts';
import type { Looking, Telling } from './editor.ts';

/** A position of the pointer on the view. */
export interface ToolPlace extends PickPlace {
  /** CSS pixels from the view's left and top edge. */
  readonly pixelX: number;
  readonly pixelY: number;
  /** The keys that are held; `control` is Ctrl or Cmd. */
  readonly alt: boolean;
  readonly shift: boolean;
  readonly control: boolean;
}

/** A pointer that moves less has clicked, not dragged; CSS pixels. */
export const stillDistance = 4;

/** How much less the pointer and keys do with Shift. */
export const fine = 0.1;

/** In CSS pixels. */
export function distanceBetween(a: ToolPlace, b: ToolPlace): number {
  return Math.hypot(a.pixelX - b.pixelX, a.pixelY - b.pixelY);
}

/** A step of a drag; changes in CSS pixels, y down. */
export interface ToolMove {
  readonly place: ToolPlace;
  readonly deltaX: number;
  readonly deltaY: number;
}

/** A drag in progress. */
export interface ToolDrag {
  move(move: ToolMove): void;
  end(): void;
  /** What the wheel does during the drag, by one step up or down, instead of zooming. */
  wheel?(step: 1 | -1): void;
  /** Undoes the whole drag, because the pointer was lost or a second finger touched. */
  cancel(): void;
}

/**
 * An action of the pointer on the view. To add one, write a file and add a line to the registry.
 */
export interface Tool {
  readonly id: string;
  /** Whether its drags change the pose; those of the others move the camera. */
  readonly poses: boolean;
  /**
   * Begins a drag, or returns null to leave it to the next tool. @param button 0 left, 1 middle, 2
   * right
   */
  press(place: ToolPlace, button: number, editor: Looking & Telling): ToolDrag | null;
}
