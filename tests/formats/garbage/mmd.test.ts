import { describe } from 'vitest';
import { testGarbage } from './garbage-of.ts';

describe('garbage for mmd', () => testGarbage('mmd'));
