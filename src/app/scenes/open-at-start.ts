import { hasLink } from './at-start.ts';
import { isReload } from './is-reload.ts';
import { openLink } from './open-link.ts';
import { restoreLast } from './restore-scene.ts';
import type { SceneParts } from './scene-parts.ts';

/** What became of a scene at the start of the page. */
interface StartOutcome {
  readonly opened: boolean;
  /** For the status line; empty if there is nothing to say. */
  readonly message: string;
}

/**
 * Opens what the page begins with: after a reload the scene that this tab had; else that of a link;
 * else, if the address names nothing, the scene that was changed last.
 */
export async function openAtStart(parts: SceneParts, isNamed: boolean): Promise<StartOutcome> {
  const isFree = !isNamed && !hasLink();
  const restored = isReload() || isFree ? await restoreLast(parts, isFree) : undefined;
  if (restored?.opened) {
    parts.opening.restored.value = restored.message;
    return restored;
  }
  if (!hasLink()) return restored ?? { opened: false, message: '' };
  const fault = await openLink(parts, location.hash);
  return { opened: fault === undefined, message: fault ?? parts.opening.notice.value };
}
