import { describe, expect, it } from 'vitest';
import { readMarkdown } from '../../../src/ui/method-help/markdown.ts';
import { helpPages, pageOfLink } from '../../../src/ui/method-help/pages.ts';
import { methods } from '../../../src/skinning/registry.ts';

describe('Markdown of our pages', () => {
  it('has headings, paragraphs over several lines, lists, and formulas that keep their lines', () => {
    const text = '# A _b_\n\none\ntwo\n\n- three\n  four\n- five\n\n    x = 1\n      y\n';
    expect(readMarkdown(text)).toEqual([
      {
        kind: 'heading',
        level: 1,
        spans: [
          { kind: 'text', text: 'A ' },
          { kind: 'emphasis', text: 'b' },
        ],
      },
      { kind: 'paragraph', spans: [{ kind: 'text', text: 'one two' }] },
      {
        kind: 'list',
        items: [[{ kind: 'text', text: 'three four' }], [{ kind: 'text', text: 'five' }]],
      },
      { kind: 'formula', text: 'x = 1\n  y' },
    ]);
  });

  it('marks parts of a text, and keeps escaped signs', () => {
    expect(readMarkdown('**a** p\\* [b](c.md) `d_e`.')).toEqual([
      {
        kind: 'paragraph',
        spans: [
          { kind: 'strong', text: 'a' },
          { kind: 'text', text: ' p* ' },
          { kind: 'link', text: 'b', to: 'c.md' },
          { kind: 'text', text: ' ' },
          { kind: 'code', text: 'd_e' },
          { kind: 'text', text: '.' },
        ],
      },
    ]);
  });
});

describe('the pages about methods', () => {
  it.each(methods.map(({ id }) => id))('say of %s what it does badly, and name a source', (id) => {
    const { title, blocks } = helpPages.find((page) => page.id === id)!;
    expect(title.length).toBeGreaterThan(4);
    const text = JSON.stringify(blocks);
    expect(text).toContain('What it does badly');
    expect(text).toMatch(/Sources?: /);
    expect(text).toContain('p′ = ');
  });

  it('lead to each other', () => {
    expect(pageOfLink('linear-blend.md')).toBe('linear-blend');
    expect(pageOfLink('normals.md#per-joint')).toBe('normals');
    expect(pageOfLink('https://example.org/linear-blend.md')).toBeUndefined();
  });
});
