import type { Format } from './format.ts';
import { cse169Format } from './cse169/format.ts';
import { mitFormat } from './mit/format.ts';

/** Every format that Sinew reads; the first that claims a file owns it. */
export const formats: readonly Format[] = [mitFormat, cse169Format];
