import type { NormalsId } from '../core/skin.ts';
import type { ActorLook } from '../document/actor-look.ts';
import type { Look, PosesBy } from '../document/session.ts';
import type { FormatId } from '../formats/registry.ts';
import type { Camera } from '../document/camera.ts';

export type WorkspaceId = 'studio' | '6.837' | 'cse169' | 'mannequin';

/** A way of working for a course or a purpose; it consists of data only. */
export interface Workspace {
  readonly id: WorkspaceId;
  readonly label: string;
  readonly camera: Camera;
  /** Whether the camera's distance and target are fitted to the character, or used unchanged. */
  readonly framed: boolean;
  /** The format whose characters offer this look, if it is a course's. */
  readonly format?: FormatId;
  /** Whether the inspector shows the numbers of all joints at once. */
  readonly listsJoints: boolean;
  /** Whether posing has the facts about the selected bone at hand. */
  readonly showsBones: boolean;
  readonly look: Look;
  /** How the selected character and new ones are drawn. */
  readonly actorLook: Partial<ActorLook>;
  /** How normals follow on a character that takes this look; as they did, if absent. */
  readonly normals?: NormalsId;
  readonly posesBy: PosesBy;
}
