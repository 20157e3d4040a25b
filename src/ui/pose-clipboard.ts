import { poseToJson } from '../formats/write-pose-json.ts';
import { copyText } from './copy-text.ts';
import type { Editor } from './editor.ts';
import { scopedJoints } from './pose-scope.ts';

/** A pose as it is copied: POSE.json with every joint that it is of. */
export interface CopiedPose {
  readonly text: string;
  /** What was copied, for the message. */
  readonly name: string;
}

/** What was copied last, for browsers that do not let the page read the clipboard. */
let last: string | null = null;

/** The shown pose of the joints in scope, or null in an empty scene. */
export function copiedPose({ session, evaluations }: Editor): CopiedPose | null {
  const shown = evaluations.selected();
  if (!shown) return null;
  const { skeleton } = shown.state.character;
  const { joints, name } = scopedJoints(session, skeleton);
  const json = poseToJson(skeleton, shown.poseToEdit, joints);
  return { text: `${JSON.stringify(json, null, 2)}\n`, name };
}

/** Copies the shown pose of the joints in scope. */
export async function copyPose(editor: Editor): Promise<void> {
  const copied = copiedPose(editor);
  if (!copied) return;
  await copyText(copied.text);
  tellCopied(editor, copied);
}

export function tellCopied({ notice }: Editor, { text, name }: CopiedPose): void {
  last = text;
  notice.value = `${name} copied`;
}

/** The text on the clipboard or, if the browser does not show it, what was copied here last. */
export async function clipboardText(): Promise<string | null> {
  try {
    return await navigator.clipboard.readText();
  } catch {
    return last;
  }
}
