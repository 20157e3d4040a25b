/** A piece of text within a block of Markdown. */
export type Span =
  | { readonly kind: 'text' | 'strong' | 'emphasis' | 'code'; readonly text: string }
  | { readonly kind: 'link'; readonly text: string; readonly to: string };

/** A block of Markdown. */
export type Block =
  | { readonly kind: 'heading'; readonly level: number; readonly spans: readonly Span[] }
  | { readonly kind: 'paragraph'; readonly spans: readonly Span[] }
  | { readonly kind: 'formula'; readonly text: string }
  | { readonly kind: 'list'; readonly items: readonly (readonly Span[])[] };

/**
 * Reads the Markdown that our own pages use: headings, paragraphs, flat lists, indented formulas, and in
 * them strong text, emphasis, code, links and escaped signs.
 */
export function readMarkdown(text: string): readonly Block[] {
  const pieces = text
    .replaceAll('\r\n', '\n')
    .trim()
    .split(/\n{2,}/);
  return pieces.map((piece): Block => {
    const heading = /^(#+) (.*)$/.exec(piece);
    if (heading) {
      return { kind: 'heading', level: heading[1]!.length, spans: readSpans(heading[2]!) };
    }
    if (piece.startsWith('    ')) {
      return { kind: 'formula', text: piece.replaceAll(/^ {4}/gm, '') };
    }
    if (piece.startsWith('- ')) {
      const items = piece.slice(2).split(/\n- /);
      return { kind: 'list', items: items.map((item) => readSpans(joined(item))) };
    }
    return { kind: 'paragraph', spans: readSpans(joined(piece)) };
  });
}

function joined(lines: string): string {
  return lines.replaceAll(/\n */g, ' ');
}

const marks = /\*\*(.+?)\*\*|_(.+?)_|`(.+?)`|\[(.+?)\]\((.+?)\)/;

function readSpans(text: string): readonly Span[] {
  const found = marks.exec(text);
  if (!found) return text === '' ? [] : [{ kind: 'text', text: text.replaceAll(/\\(.)/g, '$1') }];
  const [all, strong, emphasis, code, link, to] = found;
  const span: Span =
    strong !== undefined
      ? { kind: 'strong', text: strong }
      : emphasis !== undefined
        ? { kind: 'emphasis', text: emphasis }
        : code !== undefined
          ? { kind: 'code', text: code }
          : { kind: 'link', text: link!, to: to! };
  const after = text.slice(found.index + all.length);
  return [...readSpans(text.slice(0, found.index)), span, ...readSpans(after)];
}
