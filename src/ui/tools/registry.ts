import type { Tool } from '../tool.ts';
import { boneTool } from './bone.ts';
import { lookTool } from './look.ts';
import { orbitTool } from './orbit.ts';

/** Every tool; a drag goes to the first that takes it. */
export const tools: readonly Tool[] = [boneTool, lookTool, orbitTool];
