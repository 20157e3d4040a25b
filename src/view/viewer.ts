import { effect, signal } from '@preact/signals-core';
import { assert } from '../core/assert.ts';
import { diagonal } from '../core/bounds.ts';
import { selectedCharacter } from '../document/document.ts';
import type { Session, SkinDevice } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import { largestBindError } from '../skinning/bind-error.ts';
import { type Camera, frameBox } from './camera.ts';
import type { CharacterView } from './character-view.ts';
import { createFrame } from './frame.ts';
import { type Picture, pictureFromGl } from './picture.ts';
import { posedBounds } from './posed-bounds.ts';
import { Renderer } from './renderer.ts';
import { type ThemeName, themes } from './theme.ts';
import { compareVertices, type Difference } from './verify.ts';

/** What `verify` found for the selected character. */
export interface Verification extends Difference {
  /** `position` over the diagonal of the character's bounds. */
  readonly relative: number;
  /** The handout's check: largest |T · B⁻¹ − I| at the file's pose. */
  readonly bindError: number;
}

/**
 * Shows the document on a canvas: the one way from state to pixels. A picture is drawn when
 * something it depends on changed, and never otherwise.
 */
export class Viewer {
  readonly camera = signal<Camera>({
    target: [0, 0.5, 0],
    distance: 2.5,
    azimuth: 0,
    elevation: 0,
    fieldOfView: 0.5,
  });
  readonly theme = signal<ThemeName>('light');
  /** Of the picture, in its own pixels. */
  readonly size = signal({ width: 1, height: 1 });
  /** How long the last change of pose took on the CPU. */
  readonly poseMilliseconds = signal(0);
  /** False while the WebGL context is lost. */
  readonly available = signal(true);
  private readonly canvas: HTMLCanvasElement;
  private readonly store: Store;
  private readonly session: Session;
  private readonly onFrame: () => void;
  private renderer: Renderer;
  private frameRequest = 0;

  /** @param onFrame called after each picture that was shown */
  constructor(
    canvas: HTMLCanvasElement,
    gl: WebGL2RenderingContext,
    store: Store,
    session: Session,
    onFrame: () => void,
  ) {
    this.canvas = canvas;
    this.store = store;
    this.session = session;
    this.onFrame = onFrame;
    this.renderer = new Renderer(gl);
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.available.value = false;
    });
    canvas.addEventListener('webglcontextrestored', () => {
      this.renderer = new Renderer(gl);
      this.available.value = true;
    });
    effect(() => {
      this.readState();
      this.requestFrame();
    });
  }

  get aspect(): number {
    return this.size.value.width / this.size.value.height;
  }

  resize(width: number, height: number): void {
    const { width: oldWidth, height: oldHeight } = this.size.value;
    if (width === oldWidth && height === oldHeight) return;
    this.canvas.width = width;
    this.canvas.height = height;
    this.size.value = { width, height };
    // The canvas is empty now; waiting for the next frame would show it so.
    this.show();
  }

  /** Turns the camera's distance and target so that all characters are in the picture. */
  frameAll(): void {
    const [first, ...rest] = this.store.document.value.characters.map(posedBounds);
    if (!first) return;
    for (const { min, max } of rest) {
      for (let i = 0; i < 3; i++) {
        first.min[i] = Math.min(first.min[i]!, min[i]!);
        first.max[i] = Math.max(first.max[i]!, max[i]!);
      }
    }
    this.camera.value = frameBox(this.camera.value, first, this.aspect);
  }

  /** Exactly what the view shows. */
  capture(): Picture {
    const { width, height } = this.size.value;
    return pictureFromGl(this.draw().readPixels(), width, height);
  }

  /** (pointCount × 3) posed positions of the selected character, file order and units. */
  vertices(device: SkinDevice): Float32Array {
    const view = this.selectedView();
    if (!view) return new Float32Array(0);
    const { positions } = view.posedVertices(device);
    return positions.slice(0, view.state.character.mesh.pointCount * 3);
  }

  /** Compares the buffers that are drawn, skinned by the GPU, with the CPU's vertices. */
  verify(): Verification | null {
    const view = this.selectedView();
    if (!view) return null;
    const { character } = view.state;
    const [gpu, cpu] = [view.posedVertices('gpu'), view.posedVertices('cpu')];
    const difference = compareVertices(gpu, cpu, character.mesh.pointOf);
    return {
      ...difference,
      relative: difference.position / (diagonal(character.bounds) || 1),
      bindError: largestBindError(character.skeleton, view.skin),
    };
  }

  /** Counts of live GL objects by kind. */
  get liveObjects(): Readonly<Record<string, number>> {
    return this.renderer.gpu.liveObjects;
  }

  private selectedView(): CharacterView | undefined {
    const document = this.store.document.value;
    const views = this.renderer.sync(document, this.session.skinDevice.value);
    const selected = selectedCharacter(document);
    return views.find(({ state }) => state === selected);
  }

  private requestFrame(): void {
    if (this.frameRequest !== 0) return;
    this.frameRequest = requestAnimationFrame(() => this.show());
  }

  private show(): void {
    cancelAnimationFrame(this.frameRequest);
    this.frameRequest = 0;
    if (!this.available.value) return;
    this.draw().show();
    this.onFrame();
  }

  private draw() {
    assert(this.available.value, 'a WebGL context that is not lost');
    const { document, device, options, theme, camera, width, height } = this.readState();
    const views = this.renderer.sync(document, device);
    const selected = views.find(({ state }) => state.id === document.selectedId);
    if (selected) this.poseMilliseconds.value = selected.poseMilliseconds;
    const frame = createFrame(views, options, themes[theme], camera, width, height);
    return this.renderer.draw(frame, width, height);
  }

  /** All signals that the picture depends on. */
  private readState() {
    const { session } = this;
    return {
      document: this.store.document.value,
      device: session.skinDevice.value,
      options: {
        showSkin: session.showSkin.value,
        showSkeleton: session.showSkeleton.value,
        showAxes: session.showAxes.value,
        faceted: session.shading.value === 'faceted',
        selectedJoint: session.selectedJoint.value,
      },
      theme: this.theme.value,
      camera: this.camera.value,
      available: this.available.value,
      ...this.size.value,
    };
  }
}
