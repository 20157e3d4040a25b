import { computed, effect, signal } from '@preact/signals-core';
import { assert } from '../core/assert.ts';
import type { Bounds } from '../core/bounds.ts';
import type { Actor } from '../document/scene.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Detail, Session, SkinDevice } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import type { Evaluations } from '../evaluation/evaluations.ts';
import type { VertexStreams } from '../skinning/method.ts';
import type { Camera } from '../document/camera.ts';
import { frameBox, startCamera } from './camera.ts';
import type { Framing } from './shot-frame.ts';
import { imageProblem } from './image-problem.ts';
import { createFrame, type Frame, pictureSize } from './frame.ts';
import type { Pace } from './pace.ts';
import type { Pass } from './pass.ts';
import { firstPasses } from './passes/first.ts';
import { sceneBounds } from '../evaluation/scene-bounds.ts';
import { refinement } from './refinement.ts';
import { Renderer } from './renderer.ts';
import { type RenderView, sideBySide, type ViewContent } from './render-view.ts';
import type { LayoutChoice } from './skinned-mesh.ts';
import { type ThemeName, themes } from './theme.ts';
import { type ViewOptions, viewOptionsOf } from './view-options.ts';

export interface CaptureSize {
  readonly width: number;
  readonly height: number;
}

/**
 * Shows the document on a canvas. It is the only path from state to pixels. A picture is drawn when
 * something it depends on changed, and never otherwise. Without a WebGL context, at first or for a
 * while, everything else continues to work.
 */
export class Viewer {
  /** Its field of view is that of a shot's picture while there is `framing`, or else of the view. */
  readonly camera = signal(startCamera);
  readonly theme = signal<ThemeName>('light');
  /** The passes in the order of drawing; a page may start with few. */
  readonly passes = signal<readonly Pass[]>(firstPasses);
  /** The size of the picture in its own pixels. */
  readonly size = signal<CaptureSize>({ width: 1, height: 1 });
  /** The time that the last change of pose took on the CPU, in milliseconds. */
  readonly poseMilliseconds = signal(0);
  /**
   * Whether there is a context to draw with. This is never so without WebGL2, and not while the
   * context is lost.
   */
  readonly available = signal(false);
  /** While this is true no picture is drawn, because what it is to show is still on its way. */
  readonly waiting = signal(false);
  /** Makes drafts of slow pictures; without it every picture is drawn in full. */
  pace: Pace | null = null;
  /** Whether there ever was a context, which distinguishes a lost one from none. */
  hadContext = false;
  /** The reason why the selected character can't be drawn, or null. */
  readonly refusal = signal<string | null>(null);
  /**
   * The ids of the visible passes, so that passes that are added but show nothing cause no new
   * picture.
   */
  private readonly shownPasses = computed(() => {
    const options = viewOptionsOf(this.session, this.store.scene.value);
    return this.passes.value.flatMap((pass) => (pass.isShown(options) ? pass.id : [])).join();
  });
  /** The views that share the picture, as while methods are compared. */
  readonly parts = signal<readonly Omit<ViewContent, 'camera'>[]>([{ overrides: {} }]);
  /** How a shot's picture lies in the view, or null while that is the whole view. */
  readonly framing = signal<Framing | null>(null);
  /** The camera of the whole view. */
  readonly viewCamera = computed(
    () => this.framing.value?.viewCamera(this.camera.value, this.aspect) ?? this.camera.value,
  );
  private readonly canvas: HTMLCanvasElement;
  private readonly store: Store;
  readonly evaluations: Evaluations;
  private readonly session: Session;
  private readonly onFrame: () => void;
  /** The detail that the effect below saw last. */
  private seenDetail: Detail = 'full';
  private renderer: Renderer | null = null;
  /** The evaluations of the page's last picture, and those of pictures in work. */
  private onPage: readonly Evaluation[] = [];
  readonly held = new Set<Evaluation>();
  private frameRequest = 0;
  /** The camera that was fitted to a box, to fit it again when the view's size changes. */
  private framed: { readonly camera: Camera; readonly box: Bounds } | null = null;

  /** @param onFrame is called after each picture that was shown */
  constructor(
    canvas: HTMLCanvasElement,
    store: Store,
    session: Session,
    evaluations: Evaluations,
    onFrame: () => void,
  ) {
    this.canvas = canvas;
    this.store = store;
    this.session = session;
    this.evaluations = evaluations;
    this.onFrame = onFrame;
    effect(() => {
      const { detail } = this.readState();
      // A change of detail is no movement.
      if (detail === this.seenDetail) this.pace?.changed();
      this.seenDetail = detail;
      this.requestFrame();
    });
  }

  /** Creates the WebGL context, if the browser has one to give, and keeps a renderer for it. */
  connect(layout: LayoutChoice): void {
    const gl = this.canvas.getContext('webgl2', { antialias: false, alpha: false, depth: false });
    if (gl) this.keepRenderer(gl, layout);
  }

  /** The contents of the view, all by one camera. */
  get contents(): readonly ViewContent[] {
    const camera = this.viewCamera.value;
    return this.parts.value.map((part) => ({ ...part, camera }));
  }

  /** The number of views that are side by side. */
  get columns(): number {
    const { value } = this.parts;
    return value[0]?.span ? 1 : value.length;
  }

  /** The aspect ratio of one of them. */
  get aspect(): number {
    const { width, height } = this.size.value;
    return width / this.columns / height;
  }

  resize(width: number, height: number): void {
    const { width: oldWidth, height: oldHeight } = this.size.value;
    if (width === oldWidth && height === oldHeight) return;
    this.canvas.width = width;
    this.canvas.height = height;
    this.size.value = { width, height };
    if (this.isFramed) this.frame(this.framed!.box);
    // Resizing empties the canvas, and it would stay empty until the next frame.
    this.show();
  }

  /** Changes the camera's distance and target so that all characters are in the picture. */
  frameAll(): void {
    this.frame(sceneBounds(this.evaluations.visible()));
  }

  /**
   * Whether what was framed is to stay in the picture: the user has not moved the camera since, and
   * it is not that of a shot, which is the same at every size.
   */
  get isFramed(): boolean {
    return this.framed?.camera === this.camera.value && !this.framing.value;
  }

  /** The reason why an actor can't be drawn, or null; it is known after the first attempt. */
  refusalOf(actor: Actor): string | null {
    return this.renderer?.refusalOf(actor) ?? null;
  }

  /**
   * Returns all posed render vertices, either from the same buffers that are drawn, skinned by the
   * GPU, or from the CPU.
   */
  skin(state: Actor, device: SkinDevice): VertexStreams {
    if (device === 'gpu') return this.readBack(state);
    const { positions, normals } = this.evaluations.of(state).vertices();
    return { positions: positions.slice(), normals: normals.slice() };
  }

  /** Settles when the pictures of all surfaces are decoded and in the view. */
  async texturesShown(): Promise<void> {
    this.drawNow(); // the views of a recent change are created only when it is drawn
    await this.renderer?.texturesLoaded();
    await new Promise((resolve) => requestAnimationFrame(resolve));
  }

  /** Draws the picture of the next animation frame at once, if there would be one. */
  drawNow(): void {
    if (this.frameRequest !== 0) this.show();
  }

  /** The counts of live GL objects by kind. */
  get liveObjects(): Readonly<Record<string, number>> {
    return this.renderer?.gpu.liveObjects ?? {};
  }

  /** Changes the camera's distance and target so that a box of the scene is in the picture. */
  frame(box: Bounds): void {
    const camera = frameBox(this.camera.value, box, this.framing.value?.ratio ?? this.aspect);
    this.framed = { camera, box };
    this.camera.value = camera;
  }

  private keepRenderer(gl: WebGL2RenderingContext, layout: LayoutChoice): void {
    const begin = (): void => {
      this.hadContext = true;
      this.renderer = new Renderer(gl, layout, (name, fault) => {
        if (fault !== null) {
          const { problems } = this.session;
          problems.value = [...problems.value, imageProblem(name, fault)];
        }
        this.requestFrame();
      });
      this.available.value = true;
    };
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault(); // otherwise it would never be restored
      this.renderer = null;
      this.available.value = false;
    });
    this.canvas.addEventListener('webglcontextrestored', begin);
    begin();
  }

  private readBack(state: Actor): VertexStreams {
    const renderer = this.present();
    const evaluation = this.evaluations.of(state);
    renderer.sync(this.evaluations.all(), 'gpu');
    const [view] = renderer.viewsOf([evaluation]);
    assert(view !== undefined, 'a character that the GPU takes');
    // If the view showed vertices from the CPU, the next picture shows them again.
    this.requestFrame();
    return view.skinned.readBack();
  }

  /** The renderer; the caller must first check that the view is `available`. */
  present(): Renderer {
    assert(this.renderer !== null && this.available.value, 'a WebGL context that is not lost');
    return this.renderer;
  }

  /** Draws the page's picture again with the next animation frame. */
  requestFrame(): void {
    if (this.frameRequest !== 0) return;
    this.frameRequest = requestAnimationFrame(() => this.show());
  }

  private show(): void {
    cancelAnimationFrame(this.frameRequest);
    this.frameRequest = 0;
    if (!this.available.value) {
      this.evaluations.keepOnly([]);
      return;
    }
    if (this.waiting.value) return;
    const begin = performance.now();
    const { contents } = this;
    // Views that are compared are compared in full.
    const detail = contents.length > 1 ? 'full' : this.session.detail.value;
    const { width, height } = pictureSize(this.size.value, detail);
    const frames = this.createFrames(sideBySide(contents, width, height), {}, detail);
    const renderer = this.present();
    renderer.draw(frames, width, height, detail).show();
    if (contents.length === 1) this.pace?.drawn(begin, renderer.gpu);
    this.onFrame();
  }

  /** @param held evaluations that a picture beside the page shows, in place of those of the page */
  createFrames(
    views: readonly RenderView[],
    changed: Partial<ViewOptions>,
    detail: Detail,
    held?: readonly Evaluation[],
  ): Frame[] {
    const { selected, device, options: own, theme } = this.readState();
    const options = { ...own, ...changed };
    const renderer = this.present();
    renderer.passes = this.passes.peek();
    const shown = views.map(({ overrides }) => held ?? this.evaluations.visible(overrides));
    if (!held) {
      this.onPage = shown.flat();
      this.evaluations.keepOnly(this.onPage);
    }
    renderer.sync([...new Set([...this.onPage, ...this.held])], device);
    this.refusal.value = selected ? renderer.refusalOf(selected) : null;
    const [first] = selected ? renderer.viewsOf([this.evaluations.of(selected)]) : [];
    if (first) this.poseMilliseconds.value = first.poseMilliseconds;
    return views.map((view, index) =>
      createFrame(
        renderer.viewsOf(shown[index]!),
        { ...options, ...view.options },
        themes[theme],
        view,
        detail,
      ),
    );
  }

  /** Reads all signals that the picture depends on. */
  private readState() {
    const { session } = this;
    return {
      selected: selectedActor(this.store, session),
      shownPasses: this.shownPasses.value,
      // A method that is not ready has a stand-in, and tells when it is.
      methods: this.contents.map(({ overrides }) =>
        this.evaluations.visible(overrides).map(({ method }) => method),
      ),
      refined: refinement.loaded,
      device: session.skinDevice.value,
      options: viewOptionsOf(session, this.store.scene.value),
      theme: this.theme.value,
      detail: session.detail.value,
      contents: this.contents,
      size: this.size.value,
      available: this.available.value,
      waiting: this.waiting.value,
    };
  }
}
