import type { Look } from '../document/session.ts';
import type { Workspace } from '../ui/workspace.ts';

const degrees = Math.PI / 180;

const skinAlone: Look = {
  showSkin: true,
  showSkeleton: false,
  skeletonStyle: 'sticks',
  showAxes: false,
  translucent: false,
};

/** All workspaces; a first visit opens the first one. */
export const workspaces: readonly Workspace[] = [
  {
    id: 'studio',
    label: 'Studio',
    listsJoints: false,
    showsBones: false,
    camera: {
      target: [0, 0.5, 0],
      distance: 2.4,
      azimuth: 36 * degrees,
      elevation: 9 * degrees,
      fieldOfView: 28 * degrees,
      projection: 'perspective',
    },
    framed: true,
    look: skinAlone,
    actorLook: { shading: 'smooth', dragging: 'follow' },
    posesBy: 'selection',
  },
  {
    id: '6.837',
    label: '6.837',
    format: 'mit',
    listsJoints: true,
    showsBones: false,
    // The camera of the course's program looks at the middle of a character 0.9 tall from a
    // distance of 1.5.
    camera: {
      target: [0, 0.5, 0],
      distance: 1.5 / 0.9,
      azimuth: 0,
      elevation: 0,
      fieldOfView: 50 * degrees,
      projection: 'perspective',
    },
    framed: false,
    look: skinAlone,
    actorLook: { shading: 'faceted', dragging: 'follow' },
    normals: 'blended',
    posesBy: 'selection',
  },
  {
    id: 'cse169',
    label: 'CSE169',
    format: 'cse169',
    listsJoints: true,
    showsBones: false,
    camera: {
      target: [0, 0.5, 0],
      distance: 2.4,
      azimuth: 36 * degrees,
      elevation: 16 * degrees,
      fieldOfView: 36 * degrees,
      projection: 'perspective',
    },
    framed: true,
    look: { ...skinAlone, showSkin: false, showSkeleton: true, skeletonStyle: 'boxes' },
    actorLook: { shading: 'smooth', dragging: 'follow' },
    normals: 'joints',
    posesBy: 'selection',
  },
  {
    id: 'mannequin',
    label: 'Mannequin',
    format: 'mmd',
    listsJoints: false,
    showsBones: true,
    camera: {
      target: [0, 0.5, 0],
      distance: 2.4,
      azimuth: 20 * degrees,
      elevation: 8 * degrees,
      fieldOfView: 45 * degrees,
      projection: 'perspective',
    },
    framed: true,
    look: { ...skinAlone, showSkeleton: true, skeletonStyle: 'lines', translucent: true },
    actorLook: { shading: 'smooth', dragging: 'course' },
    normals: 'blended',
    posesBy: 'mode',
  },
];
