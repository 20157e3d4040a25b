import { type CharacterState, type Document, selectedCharacter } from '../document/document.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import type { Evaluation } from './evaluation.ts';
import { Evaluator } from './evaluator.ts';

/**
 * The document as it is shown at the session's time: one evaluator a character, which view, picking,
 * panels, pictures and exports share. To read follows the document and the time.
 */
export class Evaluations {
  private readonly store: Store;
  private readonly session: Session;
  private readonly evaluators = new Map<number, Evaluator>();

  constructor(store: Store, session: Session) {
    this.store = store;
    this.session = session;
  }

  /** Of every character; evaluators of those that are gone are let go. */
  all(): readonly Evaluation[] {
    const document = this.store.document.value;
    this.forget(document);
    return document.characters.map((state) => this.of(state));
  }

  /** Of the selected character, if there is one. */
  selected(): Evaluation | undefined {
    const state = selectedCharacter(this.store.document.value);
    return state && this.of(state);
  }

  private of(state: CharacterState): Evaluation {
    let evaluator = this.evaluators.get(state.id);
    if (!evaluator?.fits(state)) {
      this.evaluators.set(state.id, (evaluator = new Evaluator(state)));
    }
    return evaluator.evaluate(state, this.session.clipTime.value);
  }

  private forget({ characters }: Document): void {
    for (const id of this.evaluators.keys()) {
      if (!characters.some((state) => state.id === id)) this.evaluators.delete(id);
    }
  }
}
