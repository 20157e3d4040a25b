import { signal } from '@preact/signals-core';
import type { Bone } from '../core/bones.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import type { KeySelection } from '../core/motion/key-selection.ts';
import type { Comparison } from './comparison.ts';
import type { CutSketch } from './cutting.ts';
import type { ActorId } from './scene.ts';
import type { ChainLength } from '../posing/ik/chain.ts';
import type { IkMethodId, Vector3 } from '../posing/ik/problem.ts';
import type { PlayMode } from '../posing/playhead.ts';
import type { ShotId } from './shots.ts';
import type { WeightViewId } from '../skinning/weights/views.ts';
import type { IkSketch } from './ik-sketch.ts';
import type { RotationPaths } from './rotation-paths.ts';
import type { Verification } from './verification.ts';

/** The processor that skins the vertices. */
export type SkinDevice = 'gpu' | 'cpu';

/** How carefully the view is drawn: a draft is coarser, and drawn only while something moves. */
export type Detail = 'draft' | 'full';

/** A degree of freedom as the interface names it: "Left elbow X". */
export interface ActiveDof {
  readonly name: string;
  /** Its index in q; for an angle of a ball, where the ball's four values start. */
  readonly index: number;
  readonly isAngle: boolean;
  /** Which of a ball's three angles it is; absent if it has a value of its own in q. */
  readonly ballAxis?: 0 | 1 | 2;
  /** Whether a drag on its limb turns it alone: a slider chooses it for that, a ring does not. */
  readonly isChosen: boolean;
}

/** The id of a handle in the view, by which a value is dragged. */
export type HandleId = string;

/** What a tool does to the whole selected character. */
export type PlaceTool = 'move' | 'turn' | 'scale';

/** The axes by which a character is moved and turned: the scene's, or its own. */
export type PlaceAxes = 'world' | 'local';

/**
 * How a skeleton is drawn: spheres and bones, the boxes of its file, both, or one line per bone.
 */
export type SkeletonStyle = 'sticks' | 'boxes' | 'both' | 'lines';

/**
 * What a left drag may pose: the limb that was selected before, or, in bone mode alone, any limb.
 * Bone mode makes every limb live in both.
 */
export type PosesBy = 'selection' | 'mode';

/** Joints of a character: all, those below the selected ones with them, or these alone. */
export type PoseScope = 'whole' | 'branch' | 'selected';

/** A limb under the pointer. */
export interface HoveredLimb {
  readonly actorId: ActorId;
  readonly joint: number;
  /** A bone that starts at the joint, or null if none does. */
  readonly bone: Bone | null;
}

/** A chain of joints that a drag moves, or would move, by inverse kinematics. */
export interface ShownChain {
  readonly actorId: ActorId;
  /** From the joint that holds the chain to the one that is dragged. */
  readonly joints: readonly number[];
  /** The dragged point, in the frame of the last joint. */
  readonly point: Vector3;
  /** Where that point is to go, in the character's space, while a drag moves it; otherwise null. */
  readonly target: Vector3 | null;
  /** Whether the point is not at the target, and a line shows how far it is. */
  readonly isApart: boolean;
}

/** What the timeline shows of a clip. */
export type TimelineView = 'keys' | 'curves';

/** Which parts of characters are shown, and how. */
export interface Look {
  readonly showSkin: boolean;
  readonly showSkeleton: boolean;
  readonly skeletonStyle: SkeletonStyle;
  readonly showAxes: boolean;
  /** Whether the skin is translucent, so that the bones inside are visible. */
  readonly translucent: boolean;
}

/** The state that is neither saved nor undone: the way in which the scene is viewed. */
export class Session {
  readonly showSkin = signal(true);
  readonly showSkeleton = signal(false);
  readonly skeletonStyle = signal<SkeletonStyle>('sticks');
  readonly showAxes = signal(false);
  readonly translucent = signal(false);
  /** How the scene is shown under several methods, or null. */
  readonly comparison = signal<Comparison | null>(null);
  /** The point of the selected actor's mesh whose ways under these methods are shown, or null. */
  readonly inspectedPoint = signal<number | null>(null);
  readonly skinDevice = signal<SkinDevice>('gpu');
  readonly detail = signal<Detail>('full');
  readonly selectedActorId = signal<ActorId | null>(null);
  /** A joint of the selected actor. */
  readonly selectedJoint = signal<number | null>(null);
  /**
   * The joints that are selected together with it, itself first; without meaning while another joint
   * is selected. It is read through `selectedJoints`.
   */
  readonly jointGroup = signal<readonly number[]>([]);
  /** Whether a click on a limb adds it to the selected ones, or takes it out of them. */
  readonly selectsSeveral = signal(false);
  /** The limb under the pointer, of any actor. */
  readonly hoveredLimb = signal<HoveredLimb | null>(null);
  /** The handle under the pointer, such as a ring. */
  readonly hoveredHandle = signal<HandleId | null>(null);
  /**
   * The pointer's position over the view while it highlights a joint, in CSS pixels from the top
   * left.
   */
  readonly hoverPlace = signal<readonly [number, number] | null>(null);
  /** The tool that places the whole selected character, while no joint is selected, or null. */
  readonly placeTool = signal<PlaceTool | null>(null);
  readonly placeAxes = signal<PlaceAxes>('world');
  /** Whether an edit of one side of a character shows on its other side too. */
  readonly liveSymmetry = signal(false);
  /** The joints that mirror the selected ones while it is on. */
  readonly mirroredJoints = signal<readonly number[]>([]);
  /** Which joints are copied and mirrored. */
  readonly poseScope = signal<PoseScope>('whole');
  /** The axes about which the rings of a joint turn it: its own, or the scene's. */
  readonly ringAxes = signal<PlaceAxes>('local');
  /** What the present drag of a handle has done so far, for the text in the view, or null. */
  readonly dragText = signal<string | null>(null);
  /** Whether every limb turns when it is dragged, not only the selected one. */
  readonly boneMode = signal(false);
  readonly posesBy = signal<PosesBy>('selection');
  /** Whether a drag on a limb moves a chain by inverse kinematics, instead of turning the joint. */
  readonly ikMode = signal(false);
  readonly ikMethod = signal<IkMethodId>('dls');
  /** The user's choice for the chains of one joint; the others end where the body branches. */
  readonly chainLength = signal<ChainLength | null>(null);
  readonly shownChain = signal<ShownChain | null>(null);
  /** Whether inverse kinematics shows handles for the targets that files name. */
  readonly showTargets = signal(true);
  /** Whether the lights have handles in the view. */
  readonly dragsLights = signal(false);
  /** Whether the view was last used by touch, where handles are larger. */
  readonly byTouch = signal(false);
  /** The shot whose frame the view shows, or null. */
  readonly shownShot = signal<ShotId | null>(null);
  /** Whether the frame shows lines at its thirds. */
  readonly showThirds = signal(false);
  /** Whether the camera stays in place and looks around. */
  readonly firstPerson = signal(false);
  /** The degree of freedom that was last changed, for the text in the view. */
  readonly activeDof = signal<ActiveDof | null>(null);
  /** The key of the pose that was applied from the library last, or null; see `LibraryPose`. */
  readonly chosenPose = signal<string | null>(null);
  /** Which of the character's clips Play binds. */
  readonly clipIndex = signal(0);
  /** Time in the bound clip, in seconds. */
  readonly clipTime = signal(0);
  readonly playing = signal(false);
  /** Seconds of the clip per second of real time. */
  readonly playSpeed = signal(1);
  readonly playMode = signal<PlayMode>('loop');
  /** False while ping-pong plays backwards. */
  readonly playForward = signal(true);
  /** Whether an edit over a bound clip is keyed when it ends. */
  readonly autoKey = signal(false);
  /** Whether times of keys and of the playhead are those of frames. */
  readonly snapsToFrames = signal(true);
  /** The part of the clip that is played instead of all of it, in seconds, or null. */
  readonly workRange = signal<readonly [number, number] | null>(null);
  /** Whether the timeline shows rows of keys or curves. */
  readonly timelineView = signal<TimelineView>('keys');
  /** The time that the timeline shows from left to right, in seconds; null is the whole clip. */
  readonly timeWindow = signal<readonly [number, number] | null>(null);
  /** The selected keys of the chosen clip of the selected actor. */
  readonly selectedKeys = signal<KeySelection>(new Map());
  /** Whether materials show their textures. */
  readonly showTextures = signal(true);
  /** Whether the selected actor shows its weights in color, and how. */
  readonly showWeights = signal(false);
  readonly weightView = signal<WeightViewId>('joints');
  /** Whether these colors are shown without light, as they are in the legend. */
  readonly unlitWeights = signal(false);
  /** The points of the selected actor's mesh under the pointer, and marked by a click, or null. */
  readonly hoveredPoint = signal<number | null>(null);
  readonly markedPoint = signal<number | null>(null);
  /** Whether normals are drawn as lines. */
  readonly showNormals = signal(false);
  /** Whether the IK lab is open, and what it draws. */
  readonly showIkLab = signal(false);
  readonly ikSketch = signal<IkSketch | null>(null);
  /** What the cutting figure draws, while it is open. */
  readonly cutSketch = signal<CutSketch | null>(null);
  /** What the rotation lab draws, while it is open. */
  readonly rotationPaths = signal<RotationPaths | null>(null);
  /** The result of verifying the selected actor. */
  readonly verification = signal<Verification | null>(null);
  /** The problems of the last files. */
  readonly problems = signal<readonly Diagnostic[]>([]);

  show(look: Look): void {
    this.showSkin.value = look.showSkin;
    this.showSkeleton.value = look.showSkeleton;
    this.skeletonStyle.value = look.skeletonStyle;
    this.showAxes.value = look.showAxes;
    this.translucent.value = look.translucent;
  }
}
