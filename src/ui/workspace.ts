import type { Look } from '../document/session.ts';
import type { Camera } from '../view/camera.ts';

export type WorkspaceId = 'studio' | '6.837' | 'cse169' | 'mannequin';

/** A way of working for a course or a purpose: data, no program of its own. */
export interface Workspace {
  readonly id: WorkspaceId;
  readonly label: string;
  readonly camera: Camera;
  /** Whether distance and target are fitted to the character, or stand as they are. */
  readonly framed: boolean;
  readonly look: Look;
}
