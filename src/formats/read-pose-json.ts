import { DiagnosticLog, type Parsed } from '../core/diagnostics.ts';
import type { Pose } from '../core/pose.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { parseJson } from './json/parse-json.ts';
import { decodePose, unused } from './pose-json.ts';

/**
 * Returns the pose that a text describes, like `poseFromJson`, with line and column in messages. It
 * is separate, so that the first picture does not have to load a parser that records places.
 */
export function readPoseJson(
  file: string,
  text: string,
  skeleton: Skeleton,
  onto?: Float64Array,
): Parsed<Pose> {
  const log = new DiagnosticLog(file);
  const json = parseJson(text, { log, area: 'pose', effect: unused });
  return json ? decodePose(json, skeleton, onto) : log.finish<Pose>(undefined);
}
