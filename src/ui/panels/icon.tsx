/** The lines of each icon, in a square of 20 units. */
const icons = {
  undo: 'M7 4 3.5 7.5 7 11M4 7.5h7.5a4.5 4.5 0 0 1 0 9H8',
  redo: 'M13 4l3.5 3.5L13 11M16 7.5H8.5a4.5 4.5 0 0 0 0 9H12',
  picture: 'M3 6.5h3L7.5 4h5L14 6.5h3v9.5H3zM10 8.2a2.8 2.8 0 1 0 0 5.6a2.8 2.8 0 0 0 0-5.6',
  search: 'M8.5 3.5a5 5 0 1 0 0 10a5 5 0 0 0 0-10M12.2 12.2 17 17',
  help: 'M7 7.2a3 3 0 1 1 4.6 2.5c-1 .7-1.6 1.2-1.6 2.4M10 15.4v.2',
  plus: 'M10 4v12M4 10h12',
  eye: 'M2.5 10C5 5.8 15 5.8 17.5 10C15 14.2 5 14.2 2.5 10M10 8a2 2 0 1 0 0 4a2 2 0 0 0 0-4',
  hidden: 'M2.5 9C5 13.2 15 13.2 17.5 9M5.2 11.4 3.6 13.4M10 12.2v2.6M14.8 11.4l1.6 2',
  copy: 'M7.5 7.5H16V16H7.5zM4 12.5V4h8.5',
  remove: 'M4 6h12M8 6V4h4v2M6 6l.7 10.5h6.6L14 6M8.7 9v4.5M11.3 9v4.5',
  skin: 'M10 2.8a2 2 0 1 0 0 4a2 2 0 0 0 0-4M6 8.5h8M7.2 8.5 7.8 13V17.2M12.8 8.5 12.2 13V17.2M10 13.4v3.8',
  skeleton:
    'M5.2 3.2a1.8 1.8 0 1 0 0 3.6a1.8 1.8 0 0 0 0-3.6M14.8 13.2a1.8 1.8 0 1 0 0 3.6a1.8 1.8 0 0 0 0-3.6M6.6 6.4l6.8 7.2',
  axes: 'M7 13V3.5M7 13h9.5M7 13 3 17M5.3 5 7 3.2 8.7 5M15 11.3l1.7 1.7L15 14.7',
  translucent: 'M10 3a7 7 0 1 0 0 14a7 7 0 0 0 0-14M10 3v14M12.5 5.5v9M15 7v6',
  weights:
    'M10 3C6 7.5 4.6 9.4 4.6 11.8a5.4 5.4 0 0 0 10.8 0C15.4 9.4 14 7.5 10 3M5 10.6h10M10 10.6V17',
  compare: 'M3 4h14v12H3zM10 4v12M5.5 8v4M14.5 7v6',
  frame: 'M3.5 7.5v-4h4M12.5 3.5h4v4M16.5 12.5v4h-4M7.5 16.5h-4v-4',
  shot: 'M3 7h10v8H3zM13 10l4-2.5v7L13 12M8 2.5v3M6.5 4h3',
  home: 'M3 10 10 4l7 6M5 9v7.5h10V9',
  look: 'M10 3.2a6.8 6.8 0 1 0 0 13.6a6.8 6.8 0 0 0 0-13.6M3.4 10c2 3 11.2 3 13.2 0M10 3.2c-4 3.4-4 10.2 0 13.6',
  pose: 'M4 16.5 9.5 11M9.5 11 9 5.5M9.5 11l6-1.5M9 3.2a1.3 1.3 0 1 0 0 .1M16.6 9.2a1.3 1.3 0 1 0 0 .1M3.4 16.5a1.3 1.3 0 1 0 0 .1',
  move: 'M10 2.5v15M2.5 10h15M8 4.5 10 2.5l2 2M8 15.5l2 2 2-2M4.5 8 2.5 10l2 2M15.5 8l2 2-2 2',
  turn: 'M16.5 10a6.5 6.5 0 1 1-2.2-4.9M14.8 2v3.4h-3.4M10 9.2a.8.8 0 1 0 .1 0',
  scale: 'M3.5 11.5v5h5v-5zM10.5 9.5 16 4M12 4h4v4',
  'own-axes':
    'M6.5 13.5 4 4M6.5 13.5 16.5 11M6.5 13.5l5.5 3.5M3 6.3 4 4l2 1.6M14.6 9.8l1.9 1.2-1.2 1.9',
  walk: 'M10.5 2.8a1.7 1.7 0 1 0 .1 0M10 7.5l-1 4.2 2.6 2.2.6 3.6M9 11.7 6.5 17M10 7.5 7 9.2v2.4M10 7.5l3 2.6 2 .4',
  list: 'M4 5.5h.1M7.5 5.5H16M4 10h.1M7.5 10H16M4 14.5h.1M7.5 14.5H16',
  close: 'M5 5l10 10M15 5 5 15',
  previous: 'M12 5l-5 5 5 5',
  next: 'M8 5l5 5-5 5',
} as const;

export type IconId = keyof typeof icons;

/** A drawing beside or instead of a name; the button that holds it has the name. */
export function Icon({ id }: { readonly id: IconId }) {
  return (
    <svg class="icon" viewBox="0 0 20 20" aria-hidden="true">
      <path d={icons[id]} />
    </svg>
  );
}
