/** Takes the keyboard to a joint's first slider, once its folder is open. */
export function focusJoint(joint: number): void {
  const slider = `.controls [data-joint="${joint}"] [role="slider"]`;
  document.querySelector<HTMLElement>(slider)?.focus();
}
