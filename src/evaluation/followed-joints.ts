import { mat4 } from 'gl-matrix';
import { type Actor, actorById, type Scene } from '../document/scene.ts';
import { displayTransform } from './display-transform.ts';
import type { Evaluation } from './evaluation.ts';

/**
 * Returns what an actor's pins follow of other characters; see `PoseContext.followed`. A joint that
 * does not exist is not followed.
 *
 * @param evaluationOf the evaluation of another actor, which does not follow this one
 */
export function followedJoints(
  actor: Actor,
  scene: Scene,
  evaluationOf: (other: Actor) => Evaluation,
): Float64Array {
  const matrices = new Float64Array(actor.pins.length * 16).fill(NaN);
  const characterFromScene = new Float64Array(16);
  mat4.invert(characterFromScene, displayTransform(actor.character, actor).sceneFromCharacter);
  actor.pins.forEach(({ follows }, at) => {
    const other = follows && actorById(scene, follows.actor);
    if (!other || follows.joint >= other.character.skeleton.jointCount) return;
    const { display, characterFromJoint } = evaluationOf(other);
    const matrix = matrices.subarray(at * 16, at * 16 + 16);
    mat4.multiply(matrix, characterFromScene, display.sceneFromCharacter);
    const joint = follows.joint * 16;
    mat4.multiply(matrix, matrix, characterFromJoint.subarray(joint, joint + 16));
  });
  return matrices;
}
