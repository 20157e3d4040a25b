import { linkOfScene, longestLink } from '../../document/scene-link.ts';
import { copyText } from '../../ui/copy-text.ts';
import type { SceneParts } from './scene-parts.ts';
import { filesOfScene, sceneText } from './scene-text.ts';

/**
 * Copies a link that opens the scene as it is viewed now. A link that is too long for many programs
 * is not copied; a dialog then offers the scene file.
 */
export async function copyLink(parts: SceneParts): Promise<void> {
  const { store, notice, dialog } = parts.opening;
  const hash = linkOfScene(sceneText(parts));
  const link = `${location.href.replace(/[?#].*/, '')}${hash}`;
  if (link.length > longestLink) {
    dialog.value = 'long link';
    return;
  }
  const files = filesOfScene(parts, store.scene.peek());
  const needs =
    files.length > 0 ? '; who opens it is asked for the files, which it only names' : '';
  if (await copyText(link)) {
    notice.value = `Link copied${needs}`;
    return;
  }
  history.replaceState(history.state, '', link);
  notice.value = `The browser did not let the link be copied; the address bar has it${needs}`;
}
