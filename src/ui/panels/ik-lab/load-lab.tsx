import '../../styles/ik-lab.css';
import { ikMethods } from '../../../posing/ik/methods.ts';
import type { SectionComponent } from '../../sections.ts';
import { Lab } from './lab.tsx';

/** Loads every method and returns the lab with them. */
export async function loadLab(): Promise<SectionComponent> {
  const methods = await Promise.all(
    ikMethods.map(async ({ id, label, summary, load }) => {
      return { id, label, summary, solver: await load() };
    }),
  );
  return function LoadedLab({ editor }) {
    return <Lab editor={editor} methods={methods} />;
  };
}
