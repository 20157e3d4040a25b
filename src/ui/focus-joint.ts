/** Moves the keyboard focus to a joint's first slider after its folder has opened. */
export function focusJoint(joint: number): void {
  const slider = `.controls [data-joint="${joint}"] [role="slider"]`;
  document.querySelector<HTMLElement>(slider)?.focus();
}
