import { decodeText } from './text/decode-text.ts';
import type { PoseCodec } from './pose-formats.ts';
import { readPoseJson } from './read-pose-json.ts';
import { poseToJson } from './write-pose-json.ts';

/** POSE.json, which always stands for the pose of the whole character. */
export const poseJsonCodec: PoseCodec = {
  read: (file, bytes, { skeleton }) => readPoseJson(file, decodeText(bytes), skeleton),
  write: ({ name, skeleton }, pose) => {
    const text = `${JSON.stringify(poseToJson(skeleton, pose), null, 2)}\n`;
    const file = { path: `${name}.pose.json`, bytes: new TextEncoder().encode(text) };
    return { files: [file], losses: [] };
  },
};
