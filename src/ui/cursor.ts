import { effect } from '@preact/signals-core';
import type { Looking } from './editor.ts';
import { isLive } from './live-limb.ts';

/** Marks the canvas with what a press would do, so that its cursor can show it. */
export function followCursor(canvas: HTMLCanvasElement, editor: Looking): void {
  effect(() => {
    const { hoveredHandle, hoveredLimb } = editor.session;
    const limb = hoveredLimb.value;
    const poses = hoveredHandle.value !== null || (limb !== null && isLive(editor, limb));
    canvas.classList.toggle('can-pose', poses);
    canvas.classList.toggle('can-select', !poses && limb !== null);
  });
}
