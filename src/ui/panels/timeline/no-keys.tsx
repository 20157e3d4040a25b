import { printable } from '../../../core/diagnostics.ts';
import type { Actor } from '../../../document/scene.ts';

/** Says how a clip gets its first key. */
export function NoKeys({ actor }: { readonly actor: Pick<Actor, 'name'> }) {
  return <p class="no-keys hint">No keys yet: pose {printable(actor.name, 80)} and press k</p>;
}
