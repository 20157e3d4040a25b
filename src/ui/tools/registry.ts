import type { Tool } from '../tool.ts';
import { boneTool } from './bone.ts';
import { ikTool } from './ik.ts';
import { lightTool } from './light.ts';
import { lookTool } from './look.ts';
import { moveJointTool } from './move-joint.ts';
import { orbitTool } from './orbit.ts';
import { pinTool } from './pin.ts';
import { placeTool } from './place.ts';
import { ringTool } from './ring.ts';
import { targetTool } from './target.ts';
import { trailTool } from './trail.ts';

/** Every tool; the first one that accepts a drag gets it. */
export const tools: readonly Tool[] = [
  lightTool,
  trailTool,
  pinTool,
  targetTool,
  ringTool,
  moveJointTool,
  placeTool,
  ikTool,
  boneTool,
  lookTool,
  orbitTool,
];
