import { signal } from '@preact/signals-core';

/** Whether the panels that measure methods are open; they stay so from character to character. */
export const measuresOpen = { sweep: signal(false) };
