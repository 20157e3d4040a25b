import { sameValue } from '../../core/same-value.ts';
import { printJson } from '../../formats/json/print-json.ts';
import type { Actor, Scene } from '../scene.ts';
import type { ViewState } from '../view-state.ts';
import { writeActor } from './actor-json.ts';
import { writeFields } from './fields.ts';
import { sceneVersion } from './migrations.ts';
import { sourceJson } from './source-json.ts';
import { plainSurroundings, surroundingsJson } from './surroundings-json.ts';
import { viewJson } from './view-json.ts';

/** Writes a scene, each of its characters once, as a text of JSON. */
export function writeScene(scene: Scene, view?: ViewState): string {
  const characters = distinctCharacters(scene);
  return printJson({
    version: sceneVersion,
    characters: characters.map(({ source }) => sourceJson.write(source)),
    actors: scene.actors.map((actor) => {
      const character = characters.findIndex((each) => sharesCharacter(each, actor));
      return writeActor(actor, character, scene.actors);
    }),
    ...writeFields(surroundingsJson, scene, plainSurroundings),
    ...(view && { view: viewJson.write(view) }),
  });
}

/** The first actor of each character of a scene. */
export function distinctCharacters({ actors }: Scene): readonly Actor[] {
  return actors.filter(
    (actor, at) => actors.findIndex((each) => sharesCharacter(each, actor)) === at,
  );
}

function sharesCharacter(a: Actor, b: Actor): boolean {
  return a.character === b.character && sameValue(a.source, b.source);
}
