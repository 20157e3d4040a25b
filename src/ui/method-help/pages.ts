import { type Block, readMarkdown } from './markdown.ts';

const texts = import.meta.glob<string>(
  '../../../docs/methods/{linear-blend,rigid,dual-quaternion,centers-of-rotation,delta-mush,normals,cutting-figure}.md',
  { query: '?raw', import: 'default', eager: true },
);

/** A page that explains a method, from the project's own documentation. */
export interface HelpPage {
  /** The name of its file without the ending; that of a method's page is the method's id. */
  readonly id: string;
  readonly title: string;
  readonly blocks: readonly Block[];
}

/** The pages in the order in which they build on each other. */
export const helpPages: readonly HelpPage[] = [
  'linear-blend',
  'rigid',
  'dual-quaternion',
  'centers-of-rotation',
  'delta-mush',
  'normals',
  'cutting-figure',
].map((id) => {
  const [heading, ...blocks] = readMarkdown(texts[`../../../docs/methods/${id}.md`]!);
  const spans = heading?.kind === 'heading' ? heading.spans : [];
  const title = spans.map(({ text }) => text).join('');
  return { id, title: title.replace(/ \(`?.*$/, ''), blocks };
});

/** The id of the page that a link of another page leads to, if it is among them. */
export function pageOfLink(to: string): string | undefined {
  return helpPages.find(({ id }) => to.startsWith(`${id}.md`))?.id;
}
