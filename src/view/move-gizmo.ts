import { mat4, type ReadonlyVec3, vec3 } from 'gl-matrix';
import { DofKind } from '../core/skeleton.ts';
import type { HandleId } from '../document/session.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import { aimedPoint } from '../posing/ik/aimed-point.ts';
import { type ChainLength, chainLength } from '../posing/ik/chain.ts';
import { placeOf } from '../posing/ik/chain-problem.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import { jointFrames, parentMatrix } from '../posing/joint-frames.ts';
import type { OverlayView } from './overlay.ts';
import { type HandleLook, type PlaceHandle, slideHandles } from './place-gizmo.ts';
import type { SessionOptions } from './view-options.ts';

/** How the handles that move the selected joint look. */
export interface MoveGizmo extends HandleLook {
  readonly joint: number;
  /** Whether they move the target of the joint's chain; otherwise they move its slides. */
  readonly isTarget: boolean;
  readonly chosen: ChainLength | null;
  readonly hovered: HandleId | null;
}

/** A handle that moves a point of the selected joint. */
export interface MoveHandle extends PlaceHandle {
  readonly joint: number;
  /** In the joint's frame. */
  readonly point: Vector3;
  readonly isTarget: boolean;
}

/** In CSS pixels: for a mouse, and for fingers. */
const [mouseRadius, touchRadius] = [64, 96];
/** Beside rings, arrows stand around them, in CSS pixels too. */
const [mouseOuter, touchOuter] = [104, 140];
/** Where such arrows begin, as a part of their radius. */
const outerStart = 0.72;
const coordinates = [0, 1, 2] as const;

/**
 * The handles are shown where the selected joint can be posed by them: with inverse kinematics at
 * the target of its chain, and otherwise beside the rings of a joint that slides.
 */
export function moveGizmoOf(options: SessionOptions): MoveGizmo | null {
  const { showOverlay, posesBy, playing, selectedJoint, byTouch, ikMode } = options;
  if (!showOverlay || posesBy === 'mode' || playing || selectedJoint === null) return null;
  const [forMouse, forTouch] = ikMode ? [mouseRadius, touchRadius] : [mouseOuter, touchOuter];
  return {
    joint: selectedJoint,
    isTarget: ikMode,
    chosen: options.chainLength,
    radius: byTouch ? forTouch : forMouse,
    hovered: options.hoveredHandle,
    ...(ikMode ? {} : { lineStart: outerStart }),
  };
}

export function moveHandles(
  evaluation: Evaluation,
  view: OverlayView,
  { joint, isTarget, chosen, radius }: MoveGizmo,
): MoveHandle[] {
  const { state, pose, characterFromJoint, display } = evaluation;
  const { skeleton } = state.character;
  const lines = isTarget ? coordinates : slideAxes();
  if (lines.length === 0) return [];
  const count = chainLength(skeleton, joint, chosen, state.pins);
  const point = isTarget ? aimedPoint(state.character, pose.q, joint, count) : origin;
  const center = vec3.transformMat4(
    new Float64Array(3),
    [...placeOf(characterFromJoint, joint, point)],
    display.sceneFromCharacter,
  );
  const directions = isTarget ? sceneAxes : slideDirections();
  const planes = isTarget ? coordinates : [];
  const handles = slideHandles('joint', { center, directions, radius, lines, planes }, view);
  // Amid rings the ring at the center would be in the way.
  const kept = isTarget ? handles : handles.filter(({ kind }) => kind === 'line');
  return kept.map((handle) => ({ ...handle, joint, point, isTarget }));

  /** The axes along which the joint slides. */
  function slideAxes(): (0 | 1 | 2)[] {
    const { dofStart, dofKind, dofAxis } = skeleton;
    return coordinates.filter((axis) => {
      for (let dof = dofStart[joint]!; dof < dofStart[joint + 1]!; dof++) {
        if (dofKind[dof] === DofKind.slide && dofAxis[dof * 3 + axis] === 1) return true;
      }
      return false;
    });
  }

  /** The axes of the frame in which the joint slides, in the scene. */
  function slideDirections(): ReadonlyVec3[] {
    const frames = jointFrames(skeleton, joint, pose.q, parentMatrix(skeleton, joint, pose.q));
    const first = frames.dofs.find(({ kind }) => kind === DofKind.slide)!;
    const matrix = new Float64Array(16);
    mat4.multiply(matrix, display.sceneFromCharacter, first.worldFromDof);
    return coordinates.map((axis) => {
      const column = matrix.slice(axis * 4, axis * 4 + 3);
      return vec3.normalize(column, column);
    });
  }
}

const origin = [0, 0, 0] as const;
const sceneAxes: readonly ReadonlyVec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
