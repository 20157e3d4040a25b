import { signal } from '@preact/signals-core';
import type { Bone } from '../core/bones.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import type { ActorId } from './scene.ts';
import type { KernelId } from '../skinning/method.ts';
import type { PlayMode } from '../posing/playhead.ts';
import type { Verification } from './verification.ts';

export type Shading = 'smooth' | 'faceted';
/** Where vertices are skinned. */
export type SkinDevice = 'gpu' | 'cpu';

/** A light far away; the first of them throws shadows. */
export interface Light {
  readonly name: string;
  /** #rrggbb, as the display has it. */
  readonly color: string;
  readonly intensity: number;
  /** Degrees about +y, from +z (where characters look) toward +x (their left). */
  readonly azimuth: number;
  /** Degrees above the floor. */
  readonly elevation: number;
}

/** A warm key from the upper left, a cool fill, a rim from behind. */
export const studioLights: readonly Light[] = [
  { name: 'Key', color: '#fff7ec', intensity: 1.45, azimuth: -18, elevation: 48 },
  { name: 'Fill', color: '#d9eaff', intensity: 0.22, azimuth: 88, elevation: 16 },
  { name: 'Rim', color: '#eef7ff', intensity: 0.5, azimuth: 168, elevation: 34 },
];

/** A degree of freedom as the interface names it: "Left elbow X". */
export interface ActiveDof {
  readonly name: string;
  /** Its place in q; of an angle of a ball where the ball's four values start. */
  readonly index: number;
  readonly isAngle: boolean;
  /** Which of a ball's three angles it is; absent where it has a value of its own in q. */
  readonly ballAxis?: 0 | 1 | 2;
}

/** How a skeleton is drawn: spheres and bones, the boxes of its file, both, or a line a bone. */
export type SkeletonStyle = 'sticks' | 'boxes' | 'both' | 'lines';

/** How a dragged bone turns: its grabbed point follows the pointer, or as CS354's program does it. */
export type BoneDrag = 'follow' | 'course';

/** What is shown of characters, and how. */
export interface Look {
  readonly showSkin: boolean;
  readonly showSkeleton: boolean;
  readonly skeletonStyle: SkeletonStyle;
  readonly showAxes: boolean;
  /** The skin lets the bones inside it show. */
  readonly translucent: boolean;
  readonly shading: Shading;
}

/** What is neither saved nor undone: how the scene is looked at. */
export class Session {
  readonly showSkin = signal(true);
  readonly showSkeleton = signal(false);
  readonly skeletonStyle = signal<SkeletonStyle>('sticks');
  readonly showAxes = signal(false);
  readonly translucent = signal(false);
  readonly shading = signal<Shading>('smooth');
  /** Shown beside each actor's own, or none. */
  readonly comparedKernel = signal<KernelId | null>(null);
  readonly skinDevice = signal<SkinDevice>('gpu');
  readonly lights = signal<readonly Light[]>(studioLights);
  readonly selectedActorId = signal<ActorId | null>(null);
  /** Of the selected actor. */
  readonly selectedJoint = signal<number | null>(null);
  /** The joint under the pointer. */
  readonly hoveredJoint = signal<number | null>(null);
  /** The bone under the pointer, which is drawn as a cylinder; it starts at the hovered joint. */
  readonly hoveredBone = signal<Bone | null>(null);
  /** Where the pointer is over the view, CSS pixels from its top left, while it lights a joint. */
  readonly hoverPlace = signal<readonly [number, number] | null>(null);
  /** Whether dragging a lit bone turns it. */
  readonly boneMode = signal(false);
  readonly boneDrag = signal<BoneDrag>('follow');
  /** The camera stands where it is and looks around. */
  readonly firstPerson = signal(false);
  /** The degree of freedom last touched, for the text in the view. */
  readonly activeDof = signal<ActiveDof | null>(null);
  /** Of the character's clips, the one that Play binds. */
  readonly clipIndex = signal(0);
  /** Seconds of the bound clip. */
  readonly clipTime = signal(0);
  readonly playing = signal(false);
  /** Seconds of the clip that pass in one. */
  readonly playSpeed = signal(1);
  readonly playMode = signal<PlayMode>('loop');
  /** False on the way back of a ping-pong. */
  readonly playForward = signal(true);
  /** Whether materials show their textures. */
  readonly showTextures = signal(true);
  /** What a check found of the selected actor's numbers. */
  readonly verification = signal<Verification | null>(null);
  /** What the last files had to say. */
  readonly problems = signal<readonly Diagnostic[]>([]);

  show(look: Look): void {
    this.showSkin.value = look.showSkin;
    this.showSkeleton.value = look.showSkeleton;
    this.skeletonStyle.value = look.skeletonStyle;
    this.showAxes.value = look.showAxes;
    this.translucent.value = look.translucent;
    this.shading.value = look.shading;
  }
}
