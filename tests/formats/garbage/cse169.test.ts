import { describe } from 'vitest';
import { testGarbage } from './garbage-of.ts';

describe('garbage for cse169', () => testGarbage('cse169'));
