import '../../styles/method-help.css';
import { useState } from 'preact/hooks';
import type { Looking } from '../../editor.ts';
import { selectedActor } from '../../../document/selected-actor.ts';
import type { Block, Span } from '../../method-help/markdown.ts';
import { helpPages, pageOfLink } from '../../method-help/pages.ts';

/** The pages about skinning methods; it opens at that of the selected character's method. */
export function MethodHelp({ editor: { store, session } }: { readonly editor: Looking }) {
  const [shown, show] = useState<string | undefined>(selectedActor(store, session)?.method);
  const page = helpPages.find(({ id }) => id === shown) ?? helpPages[0]!;
  return (
    <>
      <nav aria-label="Pages">
        {helpPages.map(({ id, title }) => (
          <button
            key={id}
            type="button"
            aria-current={id === page.id ? 'page' : undefined}
            onClick={() => show(id)}
          >
            {title}
          </button>
        ))}
      </nav>
      <article key={page.id} aria-label={page.title}>
        {page.blocks.map((block, index) => (
          <ShownBlock key={index} block={block} show={show} />
        ))}
      </article>
    </>
  );
}

interface ShownBlockProperties {
  readonly block: Block;
  /** Shows another page. */
  readonly show: (id: string) => void;
}

function ShownBlock({ block, show }: ShownBlockProperties) {
  switch (block.kind) {
    case 'heading':
      return (
        <h3>
          <Spans spans={block.spans} show={show} />
        </h3>
      );
    case 'formula':
      return <pre tabIndex={0}>{block.text}</pre>;
    case 'list':
      return (
        <ul>
          {block.items.map((spans, index) => (
            <li key={index}>
              <Spans spans={spans} show={show} />
            </li>
          ))}
        </ul>
      );
    case 'paragraph':
      return (
        <p>
          <Spans spans={block.spans} show={show} />
        </p>
      );
  }
}

interface SpansProperties extends Pick<ShownBlockProperties, 'show'> {
  readonly spans: readonly Span[];
}

function Spans({ spans, show }: SpansProperties) {
  return (
    <>
      {spans.map((span, index) => {
        const { kind, text } = span;
        if (kind === 'strong') return <strong key={index}>{text}</strong>;
        if (kind === 'emphasis') return <em key={index}>{text}</em>;
        if (kind === 'code') return <code key={index}>{text}</code>;
        const id = kind === 'link' ? pageOfLink(span.to) : undefined;
        if (id === undefined) return text;
        return (
          <button key={index} type="button" class="link" onClick={() => show(id)}>
            {text}
          </button>
        );
      })}
    </>
  );
}
