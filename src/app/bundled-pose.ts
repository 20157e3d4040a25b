import type { Diagnostic } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { poseFromJson } from '../formats/pose-json.ts';
import type { LooseFile } from '../workers/read-characters-task.ts';

/**
 * The pose of a bundled character. The browser's own parser reads it, since the first picture waits for
 * it; the one that knows lines and columns comes only where there is something to say.
 */
export async function readBundledPose(
  { path, bytes }: LooseFile,
  skeleton: Skeleton,
  problems: Diagnostic[],
): Promise<Float64Array | undefined> {
  const text = new TextDecoder().decode(bytes);
  const { value, diagnostics } = poseFromJson(path, parse(text), skeleton);
  if (value && diagnostics.length === 0) return value.q;
  const { readPoseJson } = await loadPart(import('../formats/read-pose-json.ts'));
  const placed = readPoseJson(path, text, skeleton);
  problems.push(...placed.diagnostics);
  return placed.value?.q;
}

function parse(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}
