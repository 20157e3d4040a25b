import { effect, untracked } from '@preact/signals-core';
import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import type { Edit } from '../document/edit.ts';
import type { Actor } from '../document/scene.ts';
import { failureText } from '../ui/attempt.ts';
import { lacksMotions, withMotions } from './bundled-motions.ts';
import type { CatalogueEntry } from './catalogue.ts';
import type { SceneParts } from './scenes/scene-parts.ts';

/** In milliseconds: how long an open gesture is left alone until it is looked at again. */
const pause = 100;

/**
 * Brings bundled characters the motions that come with them, after they opened without. That is no
 * step of undo. Where undo leads back to a scene from before, its characters get them too.
 */
export class MotionFollower {
  private readonly parts: SceneParts;
  /** Characters whose motions could not be fetched; nobody is told twice. */
  private readonly failed = new WeakSet<Character>();
  private work: Promise<void> = Promise.resolve();

  constructor(parts: SceneParts) {
    this.parts = parts;
    effect(() => {
      const { actors } = parts.opening.store.scene.value;
      untracked(() => {
        if (actors.some((actor) => this.waits(actor))) this.work = this.bringNext();
      });
    });
  }

  /** Resolves when all characters of the scene have their motions, or can't have them. */
  async whenDone(): Promise<void> {
    let last;
    do await (last = this.work);
    while (last !== this.work);
  }

  private async bringNext(): Promise<void> {
    const before = this.work;
    await before;
    const { store, session } = this.parts.opening;
    const problems: Diagnostic[] = [];
    const found = new Map<Character, Character>();
    for (const actor of store.scene.peek().actors) {
      const full = this.waits(actor) && (await this.complete(actor, problems));
      if (full) found.set(actor.character, full);
    }
    if (found.size === 0) return;
    // To amend the scene would end what the user drags.
    while (store.isEditing) await new Promise((resolve) => setTimeout(resolve, pause));
    store.amend(giveMotions(found));
    if (problems.length > 0) session.problems.value = [...session.problems.value, ...problems];
  }

  private async complete(actor: Actor, problems: Diagnostic[]): Promise<Character | undefined> {
    const { opening, opener } = this.parts;
    const { character } = actor;
    try {
      const full = await withMotions(this.entryOf(actor) ?? {}, character, problems);
      opener.keep({ character: full, files: opener.filesOf(character) });
      return full;
    } catch (error) {
      this.failed.add(character);
      opening.notice.value = failureText(error);
      return undefined;
    }
  }

  /** Whether an actor is to get motions. */
  private waits(actor: Actor): boolean {
    const entry = this.entryOf(actor);
    if (!entry || this.failed.has(actor.character)) return false;
    return lacksMotions(entry, actor.character);
  }

  private entryOf({ source }: Actor): CatalogueEntry | undefined {
    return source.kind === 'bundled' ? this.parts.entryOf(source.id) : undefined;
  }
}

/**
 * Replaces characters by those that have their motions too. The clips that an actor has stay where
 * they are, changed or not; the motions come after them.
 *
 * @param found by the character without them
 */
function giveMotions(found: ReadonlyMap<Character, Character>): Edit {
  return {
    label: 'Motions',
    apply: (scene) => ({
      ...scene,
      actors: scene.actors.map((actor) => {
        const character = found.get(actor.character);
        if (!character) return actor;
        const { clips } = actor;
        if (clips === actor.character.clips) return { ...actor, character, clips: character.clips };
        const known = [...clips, ...actor.character.clips].map(({ name }) => name);
        const came = character.clips.filter(({ name }) => !known.includes(name));
        return { ...actor, character, clips: [...clips, ...came] };
      }),
    }),
  };
}
