import { effect, type ReadonlySignal, signal } from '@preact/signals-core';
import type { ThemeChoice } from '../ui/editor.ts';
import type { Viewer } from '../view/viewer.ts';

/**
 * Uses light or dark colors for the page and the scene, as the user chose or else as the system has
 * it.
 */
export function followTheme(choice: ReadonlySignal<ThemeChoice>, viewer: Viewer): void {
  const query = matchMedia('(prefers-color-scheme: dark)');
  const systemIsDark = signal(query.matches);
  query.addEventListener('change', () => (systemIsDark.value = query.matches));
  effect(() => {
    const wanted = choice.value;
    const system = systemIsDark.value ? 'dark' : 'light';
    const theme = wanted === 'system' ? system : wanted;
    viewer.theme.value = theme;
    document.documentElement.dataset['theme'] = theme;
  });
}
