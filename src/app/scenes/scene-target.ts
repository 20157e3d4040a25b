/** Where the scene is saved. */
export interface SceneTarget {
  /** The file in which it was saved or from which it came; the next saving overwrites it. */
  handle: FileSystemFileHandle | null;
  /** The name that a new file gets, without extension. */
  name: string;
  /** Under which the browser keeps the scene. */
  id: string;
}

/** A target for another scene, so that what was saved of the one before stays as it is. */
export function freshTarget(name = 'scene'): SceneTarget {
  return {
    handle: null,
    name,
    id: `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`,
  };
}
