import { effect, signal } from '@preact/signals-core';
import { assert } from '../core/assert.ts';
import { worldMatrices } from '../core/forward-kinematics.ts';
import { type CharacterState, selectedCharacter, skinInUse } from '../document/document.ts';
import type { Session, SkinDevice } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { VertexStreams } from '../skinning/method.ts';
import { methodById } from '../skinning/registry.ts';
import { skinVertices } from '../skinning/skin-vertices.ts';
import { type Camera, frameBox } from './camera.ts';
import { displayTransform } from './display-transform.ts';
import { createFrame, type Frame } from './frame.ts';
import { pickJoint, rayThrough, sizeOfPixel } from './picking.ts';
import { type Picture, pictureFromGl } from './picture.ts';
import { posedBounds, unite } from './posed-bounds.ts';
import { Renderer } from './renderer.ts';
import type { LayoutChoice } from './skinned-mesh.ts';
import { type ThemeName, themes } from './theme.ts';
import { type Verification, verifySkin } from './verify.ts';

export interface CaptureSize {
  readonly width: number;
  readonly height: number;
}

/**
 * Shows the document on a canvas: the one way from state to pixels. A picture is drawn when
 * something it depends on changed, and never otherwise. Without a WebGL context, at first or for a
 * while, everything else goes on.
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
  readonly size = signal<CaptureSize>({ width: 1, height: 1 });
  /** How long the last change of pose took on the CPU. */
  readonly poseMilliseconds = signal(0);
  /** Whether there is a context to draw with: never without WebGL2, not while it is lost. */
  readonly available = signal(false);
  /** Whether there ever was a context: tells a lost one from none. */
  hadContext = false;
  /** Why the selected character can't be drawn, or null. */
  readonly refusal = signal<string | null>(null);
  private readonly canvas: HTMLCanvasElement;
  private readonly store: Store;
  private readonly session: Session;
  private readonly onFrame: () => void;
  private renderer: Renderer | null = null;
  private frameRequest = 0;

  /** @param onFrame called after each picture that was shown */
  constructor(
    canvas: HTMLCanvasElement,
    store: Store,
    session: Session,
    layout: LayoutChoice,
    onFrame: () => void,
  ) {
    this.canvas = canvas;
    this.store = store;
    this.session = session;
    this.onFrame = onFrame;
    const gl = canvas.getContext('webgl2', { antialias: false, alpha: false, depth: false });
    if (gl) this.keepRenderer(gl, layout);
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
    const boxes = this.store.document.value.characters.map(posedBounds);
    this.camera.value = frameBox(this.camera.value, unite(boxes), this.aspect);
  }

  /**
   * Exactly what the view shows; or the same view at another size, or without its studio.
   * A caller asks first whether the view is `available`.
   */
  capture(size: CaptureSize = this.size.value, showStudio = true): Picture {
    const { width, height } = size;
    const frame = this.createFrame(width, height, showStudio);
    return pictureFromGl(this.present().capture(frame, width, height), width, height);
  }

  /**
   * The joint of the selected character under a point of the view, where its skeleton is shown.
   * @param x from -1 (left) to 1; @param y from -1 (bottom) to 1
   * @param pixels how near is near enough, in CSS pixels of a view `viewHeight` tall
   */
  pick(x: number, y: number, pixels: number, viewHeight: number): number | null {
    const state = selectedCharacter(this.store.document.value);
    if (!state || !this.session.showSkeleton.value) return null;
    const { character, q } = state;
    const camera = this.camera.value;
    const target = {
      character,
      display: displayTransform(character),
      worldFromJoint: worldMatrices(character.skeleton, q),
    };
    const tolerance = pixels * sizeOfPixel(camera, viewHeight);
    return pickJoint(target, rayThrough(camera, this.aspect, x, y), tolerance)?.joint ?? null;
  }

  /** (pointCount × 3) posed positions of the selected character, file order and units. */
  vertices(device: SkinDevice): Float32Array {
    const state = selectedCharacter(this.store.document.value);
    if (!state) return new Float32Array(0);
    const { positions } = device === 'gpu' ? this.readBack(state) : skinOnCpu(state);
    return positions.slice(0, state.character.mesh.pointCount * 3);
  }

  /** Compares the buffers that are drawn, skinned by the GPU, with the CPU's vertices. */
  verify(): Verification | null {
    const state = selectedCharacter(this.store.document.value);
    if (!state || !this.available.value || this.refusal.value !== null) return null;
    return verifySkin(state, this.readBack(state), skinOnCpu(state));
  }

  /** Counts of live GL objects by kind. */
  get liveObjects(): Readonly<Record<string, number>> {
    return this.renderer?.gpu.liveObjects ?? {};
  }

  private keepRenderer(gl: WebGL2RenderingContext, layout: LayoutChoice): void {
    const begin = (): void => {
      this.hadContext = true;
      this.renderer = new Renderer(gl, layout);
      this.available.value = true;
    };
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault(); // or it would never be restored
      this.renderer = null;
      this.available.value = false;
    });
    this.canvas.addEventListener('webglcontextrestored', begin);
    begin();
  }

  private readBack(state: CharacterState): VertexStreams {
    const views = this.present().sync(this.store.document.value, 'gpu');
    const view = views.find((each) => each.state === state);
    assert(view !== undefined, 'a character that the GPU takes');
    // What was shown from the CPU comes back with the next picture.
    this.requestFrame();
    return view.skinned.readBack();
  }

  private present(): Renderer {
    assert(this.renderer !== null && this.available.value, 'a WebGL context that is not lost');
    return this.renderer;
  }

  private requestFrame(): void {
    if (this.frameRequest !== 0) return;
    this.frameRequest = requestAnimationFrame(() => this.show());
  }

  private show(): void {
    cancelAnimationFrame(this.frameRequest);
    this.frameRequest = 0;
    if (!this.available.value) return;
    const { width, height } = this.size.value;
    this.present()
      .draw(this.createFrame(width, height, true), width, height)
      .show();
    this.onFrame();
  }

  private createFrame(width: number, height: number, showStudio: boolean): Frame {
    const { document, device, options, theme, camera } = this.readState();
    const renderer = this.present();
    const views = renderer.sync(document, device);
    const selected = selectedCharacter(document);
    this.refusal.value = selected ? renderer.refusalOf(selected) : null;
    const shown = views.find(({ state }) => state === selected);
    if (shown) this.poseMilliseconds.value = shown.poseMilliseconds;
    const all = { ...options, showStudio };
    return createFrame(views, all, themes[theme], camera, width, height);
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
        translucent: session.translucent.value,
        faceted: session.shading.value === 'faceted',
        selectedJoint: session.selectedJoint.value,
        hoveredJoint: session.hoveredJoint.value,
        lights: session.lights.value,
      },
      theme: this.theme.value,
      camera: this.camera.value,
      size: this.size.value,
      available: this.available.value,
    };
  }
}

function skinOnCpu(state: CharacterState): VertexStreams {
  const { character, q, method } = state;
  return skinVertices(character, skinInUse(state), { q }, methodById(method));
}
