import type { Signal } from '@preact/signals-core';
import type { CurveModel } from '../../../curve-editor/curve-model.ts';
import type { Shown } from '../../../curve-editor/hits.ts';
import type { Box } from '../../../curve-editor/scale-box.ts';
import type { Editor } from '../../../editor.ts';

/** The plot on the page, for those who listen to the pointer over it. */
export interface PlotView {
  readonly canvas: HTMLCanvasElement;
  readonly editor: Editor;
  readonly model: CurveModel;
  /** What the plot shows now. */
  readonly shown: () => Shown;
  /** The rectangle by which keys are being selected, or null. */
  readonly chosenBox: Signal<Box | null>;
  /**
   * Opens the menu of the selected keys at a place of the page.
   *
   * @param isHeld whether a finger that opens it is still down
   */
  openMenu(x: number, y: number, isHeld: boolean): void;
}
