import type { PickPlace } from '../view/pick.ts';
import type { Editor } from './editor.ts';

/** A pointer on the view; positions and changes in CSS pixels, y down. */
export interface ToolPointer {
  /** 0 left, 1 middle, 2 right. */
  readonly button: number;
  readonly deltaX: number;
  readonly deltaY: number;
  /** Height of the view, to which moves are relative. */
  readonly viewHeight: number;
}

/** A seam: what a pointer does on the view. A new tool is one file and one line in the registry. */
export interface Tool {
  readonly id: string;
  drag(pointer: ToolPointer, editor: Editor): void;
  /** The pointer moves over the view without a button, or leaves it (null). */
  hover(place: PickPlace | null, editor: Editor): void;
  /** Pressed and let go at one place. */
  click(place: PickPlace, editor: Editor): void;
}
