import type { Tool } from '../tool.ts';
import { boneTool } from './bone.ts';
import { lookTool } from './look.ts';
import { orbitTool } from './orbit.ts';
import { placeTool } from './place.ts';
import { ringTool } from './ring.ts';

/** Every tool; the first one that accepts a drag gets it. */
export const tools: readonly Tool[] = [ringTool, placeTool, boneTool, lookTool, orbitTool];
