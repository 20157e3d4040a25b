import { effect } from '@preact/signals-core';
import type { Session } from '../document/session.ts';

/**
 * Lays down the tool for whole characters when something else takes the drags: a joint that is
 * selected, bone mode, or the first-person camera.
 */
export function keepOneTool({ placeTool, selectedJoint, boneMode, firstPerson }: Session): void {
  effect(() => {
    if (selectedJoint.value !== null || boneMode.value || firstPerson.value) placeTool.value = null;
  });
}
