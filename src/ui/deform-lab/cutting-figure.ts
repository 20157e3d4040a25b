import { computed, effect, type Signal } from '@preact/signals-core';
import { mat3, type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { CutRole } from '../../document/cutting.ts';
import type { Actor } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { cuttingPlane, type Facing } from '../../evaluation/comparison/cutting-plane.ts';
import {
  cornersOf,
  cornersOfParts,
  planeLines,
  pointOf,
} from '../../evaluation/comparison/plane-lines.ts';
import { verticesBy } from '../../evaluation/comparison/vertices-by.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { tellingJoint } from '../../posing/telling-poses.ts';
import type { MethodId } from '../../skinning/method.ts';
import { kernelById } from '../../skinning/registry.ts';
import type { Vector3 } from '../../posing/ik/problem.ts';
import { axesOf } from '../../view/camera.ts';
import type { Editor } from '../editor.ts';
import { onceAFrame } from '../once-a-frame.ts';
import { cuttingSettings } from './cutting-settings.ts';
import type { Figure, FigureOutline } from './figure-paths.ts';

/** The parts of the editor that the figure uses. */
type FigureEditor = Pick<Editor, 'store' | 'session' | 'evaluations' | 'viewer' | 'tab'>;

/** What a figure is of. */
interface Subject {
  readonly actor: Actor;
  readonly joint: number;
}

/**
 * The cutting figure while it is open: it follows pose, selection and plane, at most once a frame, and
 * has the view draw the same lines.
 */
export class CuttingFigure {
  private readonly editor: FigureEditor;
  private readonly positions = new Map<CutRole, Float32Array<ArrayBuffer>>();
  private readonly end: () => void;
  private readonly figure: Signal<Figure | null>;
  private drawn = '';

  /** The selected joint, or that at which methods differ most clearly. */
  private readonly subject = computed((): Subject | null => {
    const { store, session } = this.editor;
    const actor = selectedActor(store, session);
    if (!actor || actor.character.mesh.pointCount === 0) return null;
    const joint = session.selectedJoint.value ?? tellingJoint(actor.character) ?? 0;
    return actor.character.skeleton.jointCount > joint ? { actor, joint } : null;
  });

  constructor(editor: FigureEditor) {
    this.editor = editor;
    this.figure = cuttingSettings(editor.session).figure;
    const draw = onceAFrame<null>(() => this.draw());
    this.end = effect(() => {
      this.state();
      draw(null);
    });
  }

  dispose(): void {
    this.end();
    this.drawn = '';
    this.figure.value = null;
    this.editor.session.cutSketch.value = null;
  }

  /** All that the figure depends on, as a text that is new when something changed. */
  private state(): string {
    const { session, evaluations, viewer, tab } = this.editor;
    const subject = this.subject.value;
    if (!subject || tab.value !== 'deform') return 'none';
    const { direction, turn, offset } = cuttingSettings(session);
    const { revisions } = evaluations.of(subject.actor);
    return JSON.stringify([
      ...[subject.actor.id, subject.joint, revisions.vertices, revisions.display],
      ...[direction.value, turn.value, offset.value],
      direction.value === 'camera' && viewer.viewCamera.value,
      this.methods().map(([, id]) => [id, this.isReady(subject.actor, id)]),
      subject.actor.methodSettings,
    ]);
  }

  private draw(): void {
    const state = this.state();
    if (state === this.drawn) return;
    this.drawn = state;
    const subject = this.subject.peek();
    const { session } = this.editor;
    if (!subject || state === 'none') {
      session.cutSketch.value = null;
      if (!subject) this.figure.value = null;
      return;
    }
    const figure = this.cut(subject);
    this.figure.value = figure;
    session.cutSketch.value = {
      actorId: subject.actor.id,
      plane: figure.plane,
      lines: figure.outlines.flatMap(({ role, lines }) =>
        lines.map(({ places, isClosed }) => {
          const points: Vector3[] = [];
          for (let i = 0; i < places.length; i += 2) {
            points.push(pointOf(figure.plane, places[i]!, places[i + 1]!));
          }
          return { role, points: isClosed ? [...points, points[0]!] : points };
        }),
      ),
    };
  }

  private cut({ actor, joint }: Subject): Figure {
    const { session, evaluations } = this.editor;
    const evaluation = evaluations.of(actor);
    const { direction, turn, offset } = cuttingSettings(session);
    const place = {
      joint,
      direction: direction.peek(),
      turn: turn.peek(),
      offset: offset.peek(),
    };
    const plane = cuttingPlane(evaluation, place, this.facing(evaluation));
    const { mesh, skeleton } = actor.character;
    const outlines = this.methods().map(([role, method]): FigureOutline => {
      const { label } = kernelById(method);
      if (!this.isReady(actor, method)) return { role, label, lines: [], isPending: true };
      const positions = this.bufferOf(role, mesh.vertexCount * 3);
      verticesBy(evaluation, { method }, evaluations.pool.kernels, positions);
      const corners = role === 'rigid' ? cornersOfParts(mesh, evaluation.skin) : cornersOf(mesh);
      return { role, label, lines: planeLines(positions, corners, plane), isPending: false };
    });
    return {
      characterName: actor.name,
      jointName: skeleton.names[joint]!,
      plane,
      outlines,
    };
  }

  /** The same array from one figure to the next. */
  private bufferOf(role: CutRole, length: number): Float32Array<ArrayBuffer> {
    let buffer = this.positions.get(role);
    if (buffer?.length !== length) this.positions.set(role, (buffer = new Float32Array(length)));
    return buffer;
  }

  private methods(): readonly (readonly [CutRole, MethodId])[] {
    const { third } = cuttingSettings(this.editor.session);
    return [
      ['rigid', 'rigid'],
      ['blend', 'linear-blend'],
      ['third', third.value],
    ];
  }

  private isReady(actor: Actor, method: MethodId): boolean {
    return this.editor.evaluations.pool.kernels.readyFor({ ...actor, method }) !== undefined;
  }

  /** The camera's directions in the character's space. */
  private facing({ display }: Evaluation): Facing {
    const { look, up } = axesOf(this.editor.viewer.viewCamera.peek());
    const characterFromScene = mat3.fromMat4(new Float64Array(9), display.sceneFromCharacter);
    mat3.invert(characterFromScene, characterFromScene);
    const turned = (direction: ReadonlyVec3): Vector3 => {
      const to: [number, number, number] = [0, 0, 0];
      vec3.normalize(to, vec3.transformMat3(to, direction, characterFromScene));
      return to;
    };
    return { toViewer: turned([-look[0], -look[1], -look[2]]), up: turned(up) };
  }
}
