import type { PickPlace } from '../view/pick.ts';
import type { Looking } from './editor.ts';

/** A place of the pointer on the view. */
export interface ToolPlace extends PickPlace {
  /** CSS pixels from the view's left, and from its top. */
  readonly pixelX: number;
  readonly pixelY: number;
  /** Whether Alt is held. */
  readonly alt: boolean;
}

/** A step of a drag; changes in CSS pixels, y down. */
export interface ToolMove {
  readonly place: ToolPlace;
  readonly deltaX: number;
  readonly deltaY: number;
}

/** A drag under way. */
export interface ToolDrag {
  move(move: ToolMove): void;
  end(): void;
  /** Takes everything back: the pointer was lost, or a second finger came. */
  cancel(): void;
}

/** A seam: what a pointer does on the view. A new tool is one file and one line in the registry. */
export interface Tool {
  readonly id: string;
  /** Begins a drag, or leaves it to the next tool. @param button 0 left, 1 middle, 2 right */
  press(place: ToolPlace, button: number, editor: Looking): ToolDrag | null;
}
