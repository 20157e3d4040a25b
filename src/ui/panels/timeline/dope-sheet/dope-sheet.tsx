import type { TimelineViewProperties } from '../../../timeline/views.ts';

/** The keys of a clip as rows of diamonds, a row a joint. */
export function DopeSheet({ clip }: TimelineViewProperties) {
  return <p class="hint">{clip.channels.length} channels</p>;
}
