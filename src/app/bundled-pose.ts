import type { Diagnostic } from '../core/diagnostics.ts';
import { loadPart } from '../core/failure.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { poseFromJson } from '../formats/pose-json.ts';
import type { LooseFile } from '../workers/read-characters-task.ts';

/**
 * Reads the pose of a bundled character with the browser's own parser, because the first picture
 * waits for it. The parser that reports lines and columns is loaded only if there is a problem to
 * report.
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
