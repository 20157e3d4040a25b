import { describe, expect, it } from 'vitest';
import { memoryFile } from '../../src/formats/file-entry.ts';
import { skelDialect } from '../../src/formats/skel-dialect.ts';
import { bytesOf } from '../support/files.ts';

describe('which course a .skel is of', () => {
  it.each([
    ['# {root} first\n0 0 0 -1\n', 'mit'],
    ['# made from a balljoint file\r\n0 0 0 -1\r\n0 1 0 0 # {tip}\r\n', 'mit'],
    ['// { }\n0 0 0 -1\n', 'mit'],
    ['0 0 0 -1\n', 'mit'],
    ['balljoint root { }\n', 'cse169'],
    ['# 0 0 0 -1\nbone { }', 'cse169'],
    ['/* 0 0 0 -1\n*/ BallJoint root\n{\n}', 'cse169'],
    ['# balljoint\n', 'cse169'],
  ] as const)('%j is told from its tokens: %s', (text, dialect) => {
    expect(skelDialect(memoryFile('a.skel', bytesOf(text)))).toBe(dialect);
  });
});
