import { loadPart } from '../../core/failure.ts';
import { attempt } from '../../ui/attempt.ts';
import { hasLink } from './at-start.ts';
import type { SceneParts } from './scene-parts.ts';

/** Opens the links that come to the open page, as when one is pasted into the address bar. */
export function followLinks(parts: SceneParts): void {
  const open = async (): Promise<void> => {
    const { openLink } = await loadPart(import('./open-link.ts'));
    const message = await openLink(parts, location.hash);
    if (message !== undefined) parts.opening.notice.value = message;
  };
  addEventListener('hashchange', () => {
    if (hasLink()) attempt(parts.opening, open());
  });
}
