import { signal } from '@preact/signals-core';

/** Whether the panels that measure methods are open; they stay so from character to character. */
export const measuresOpen = { sweep: signal(false), stress: signal(false) };

/** Whether the pictures and the table of the stress suite are shown below the view. */
export const showsStressSheet = signal(false);
