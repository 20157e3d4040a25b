import type { GUI } from 'lil-gui';

/**
 * Adds a search field above the rows that come after it.
 *
 * @param filter gets what is typed, in lower case
 */
export function addSearch(
  folder: GUI,
  name: string,
  placeholder: string,
  filter: (wanted: string) => void,
): void {
  const field = document.createElement('input');
  field.type = 'search';
  field.className = 'dof-search';
  field.placeholder = placeholder;
  field.setAttribute('aria-label', name);
  field.addEventListener('input', () => filter(field.value.trim().toLowerCase()));
  folder.$children.append(field);
}
