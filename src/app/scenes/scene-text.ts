import { distinctCharacters, writeScene } from '../../document/scene-json/write-scene.ts';
import type { Scene } from '../../document/scene.ts';
import { viewStateOf } from '../../document/view-state.ts';
import type { FileEntry } from '../../formats/format.ts';
import type { SceneParts } from './scene-parts.ts';

/** The scene and its view as JSON. Reading subscribes to all of it. */
export function sceneText({ opening, workspaceId }: SceneParts): string {
  const { store, session, viewer } = opening;
  const scene = store.scene.value;
  return writeScene(scene, viewStateOf(scene, session, viewer.camera.value, workspaceId.value));
}

/** The user's own files that the scene needs, each once. */
export function filesOfScene({ opener }: SceneParts, scene: Scene): readonly FileEntry[] {
  const files = new Map<string, FileEntry>();
  for (const { source, character } of distinctCharacters(scene)) {
    if (source.kind !== 'files') continue;
    for (const file of opener.filesOf(character)) {
      const key = file.sha256 ?? file.path;
      if (!files.has(key)) files.set(key, file);
    }
  }
  return [...files.values()];
}
