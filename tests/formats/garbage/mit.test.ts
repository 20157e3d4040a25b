import { describe } from 'vitest';
import { testGarbage } from './garbage-of.ts';

describe('garbage for mit', () => testGarbage('mit'));
