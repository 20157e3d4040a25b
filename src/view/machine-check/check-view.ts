import type { Character } from '../../core/character.ts';
import { Failure } from '../../core/failure.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { setMethod, setNormals, setPose } from '../../document/edits.ts';
import { openCharacter } from '../../document/open-characters.ts';
import type { ActorId } from '../../document/scene.ts';
import type { Verification } from '../../document/verification.ts';
import { nextTask } from '../../gl/fence.ts';
import { Gpu } from '../../gl/gpu.ts';
import type { KernelId } from '../../skinning/method.ts';
import { deformationOf, kernels } from '../../skinning/registry.ts';
import { verifyShown } from '../verify.ts';
import { type FrameTimes, timeFrames } from './frame-times.ts';
import { type LinkedProgram, programLinks } from './link-programs.ts';
import { type MachineFacts, machineFacts } from './machine-facts.ts';
import { createOwnView, type OwnView } from './own-view.ts';

/** How far the GPU's vertices are from those of the CPU. */
export interface KernelParity extends Verification {
  readonly kernel: KernelId;
}

/** What Sinew measured on a machine. */
export interface ViewReport {
  readonly machine: MachineFacts;
  readonly programs: readonly LinkedProgram[];
  /** Of each kernel, in a pose. */
  readonly parity: readonly KernelParity[];
  readonly frames: {
    /** Of the picture, in pixels. */
    readonly width: number;
    readonly height: number;
    readonly vertices: number;
    readonly triangles: number;
    /** The pose changes in each frame. */
    readonly posed: FrameTimes;
    /** Only the camera moves. */
    readonly camera: FrameTimes;
  };
}

/** Reports what is done next, lets the page go on, and throws if the check was canceled. */
type Step = (label: string, fraction: number) => Promise<void>;

/** In pixels: about what the page's view has on a usual screen. */
const pictureSize = { width: 904, height: 863 };

/**
 * Links every program, compares the vertices of every kernel, and times frames.
 *
 * @param character needs hinges to be posed
 * @throws Failure without WebGL2, or if the context is lost meanwhile
 */
export async function checkView(
  character: Character,
  signal: AbortSignal,
  onProgress: (label: string, fraction: number) => void,
): Promise<ViewReport> {
  const view = await createOwnView(pictureSize);
  const { gl, store, viewer } = view;
  const gpu = new Gpu(gl);
  const step: Step = async (label, fraction) => {
    onProgress(label, fraction);
    await nextTask();
    signal.throwIfAborted();
    if (gl.isContextLost()) throw new Failure('The GPU was reset while it was checked');
  };
  try {
    const programs = await linkAll(gpu, step);
    store.dispatch(openCharacter(null, character, 'linear-blend'));
    viewer.frameAll();
    const { id } = store.scene.value.actors[0]!;
    const parity = await compareKernels(view, id, step);

    await step('timing frames', 0.6);
    const posed = await timeFrames(gpu, poser(view, id), signal);
    await step('timing frames', 0.8);
    const camera = await timeFrames(gpu, turner(view), signal);
    const { vertexCount: vertices, indices } = character.mesh;
    return {
      machine: machineFacts(gl),
      programs,
      parity,
      frames: { ...pictureSize, vertices, triangles: indices.length / 3, posed, camera },
    };
  } finally {
    view.dispose();
  }
}

async function linkAll(gpu: Gpu, step: Step): Promise<LinkedProgram[]> {
  const methods = await Promise.all(kernels.map(({ load }) => load()));
  const links = programLinks(gpu, methods);
  const linked: LinkedProgram[] = [];
  for (const link of links) {
    await step('linking programs', (0.4 * linked.length) / links.length);
    linked.push(link());
  }
  return linked;
}

async function compareKernels(view: OwnView, id: ActorId, step: Step): Promise<KernelParity[]> {
  const { store, viewer } = view;
  const parity: KernelParity[] = [];
  for (const [index, { id: kernel, label }] of kernels.entries()) {
    await step(`comparing ${label}`, 0.4 + (0.2 * index) / kernels.length);
    const { method, normals } = deformationOf(kernel);
    store.dispatch(setMethod(id, method));
    store.dispatch(setNormals(id, normals));
    poser(view, id)(index + 1);
    const found = verifyShown(store.scene.value.actors[0], viewer);
    if (!found) throw new Failure('The GPU can’t draw the character of the check');
    if (found.isOnCpu) continue;
    parity.push({ kernel, ...found });
  }
  return parity;
}

/** Returns a function that draws the actor in another pose for each number. */
function poser({ store, viewer }: OwnView, id: ActorId): (frame: number) => void {
  const { skeleton } = store.scene.value.actors[0]!.character;
  const gesture = store.begin('Pose');
  return (frame) => {
    gesture.preview(setPose(id, swayed(skeleton, frame)));
    viewer.drawNow();
  };
}

/** Returns a function that draws the scene from another side for each number. */
function turner({ viewer }: OwnView): (frame: number) => void {
  const start = viewer.camera.value;
  return (frame) => {
    viewer.camera.value = { ...start, azimuth: start.azimuth + 0.1 * Math.sin(frame) };
    viewer.drawNow();
  };
}

/** A pose in which every hinge is turned by up to 0.2 radians; each number gives another one. */
function swayed({ dofKind, dofQ, qRest }: Skeleton, frame: number): Float64Array {
  const q = qRest.slice();
  dofKind.forEach((kind, dof) => {
    if (kind === DofKind.hinge) q[dofQ[dof]!]! += 0.2 * Math.sin(0.7 * frame + dof);
  });
  return q;
}
