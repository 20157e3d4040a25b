import { sceneOfLink } from '../../document/scene-link.ts';
import { openGivenScene, whyRefused } from './open-given-scene.ts';
import type { SceneParts } from './scene-parts.ts';

/**
 * Opens the scene of a link. If the link is damaged, a message says so, and the page stays as it was.
 *
 * @param hash of the address
 * @returns the message, or nothing if the scene was opened
 */
export async function openLink(parts: SceneParts, hash: string): Promise<string | undefined> {
  const read = sceneOfLink(hash);
  if ('fault' in read) return `The link could not be opened: ${read.fault}`;
  const given = { file: 'link', text: read.text, files: [] };
  const how = { name: 'The scene of the link', strict: true };
  const { opening } = parts;
  const opened = await opening.whileWorking('Opening the link', (signal) =>
    openGivenScene(parts, given, signal, how),
  );
  if (opened === undefined) return opening.notice.value; // canceled or failed, as it says
  return opened ? undefined : `The link could not be opened: ${whyRefused(parts)}`;
}
