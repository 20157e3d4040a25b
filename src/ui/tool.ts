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

/** Where a pointer is, for picking. */
export interface ToolPlace {
  /** From -1 (left) to 1. */
  readonly x: number;
  /** From -1 (bottom) to 1. */
  readonly y: number;
  /** How near is near enough, CSS pixels: more for a finger. */
  readonly tolerance: number;
  readonly viewHeight: number;
}

/** A seam: what a pointer does on the view. A new tool is one file and one line in the registry. */
export interface Tool {
  readonly id: string;
  drag(pointer: ToolPointer, editor: Editor): void;
  /** The pointer moves over the view without a button, or leaves it (null). */
  hover(place: ToolPlace | null, editor: Editor): void;
  /** Pressed and let go at one place. */
  click(place: ToolPlace, editor: Editor): void;
}
