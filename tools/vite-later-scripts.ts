import path from 'node:path';
import type { Rolldown } from 'vite';

const folder = path.resolve(import.meta.dirname, '../src');
/** The page's first script, and what reads the first character: they have scripts of their own. */
const first = [
  ...['app/main.ts', 'app/bundled-pose.ts', 'formats/read-characters.ts', 'formats/mit/reader.ts'],
  ...['formats/obj/read-obj.ts', 'formats/obj/read-mtl.ts'],
];
/** The page's tools, and the sections that the first visit shows: both come after that picture. */
const later = {
  tools: ['app/start-interface.tsx', 'app/scenes/keep-scene.ts', 'app/bundled-motions.ts'],
  sections: [
    ...[
      'bone',
      'camera',
      'environment',
      'ik',
      'morph',
      'picture',
      'pins',
      'place',
      'pose',
      'view',
    ].map((name) => `ui/controls/${name}-folder.ts`),
    ...['ik-lab', 'pose-library', 'shots-panel'].map((name) => `ui/panels/${name}.tsx`),
  ],
};

/**
 * Packs what comes right after the first picture in two scripts. Every module that some of its parts
 * share would be a script of its own otherwise, which are some eighty.
 */
export function laterScripts(): Rolldown.CodeSplittingGroup {
  /** The script of each module, once it is known; null is that of the first picture. */
  let scripts: Map<string, string | null> | undefined;
  return {
    debugName: 'later scripts',
    priority: -1,
    includeDependenciesRecursively: false,
    name(id, context) {
      if (!scripts) {
        scripts = new Map();
        const add = (module: string, script: string | null): void => {
          if (scripts!.has(module)) return;
          scripts!.set(module, script);
          for (const each of context.getModuleInfo(module)?.importedIds ?? []) add(each, script);
        };
        for (const each of first) add(fileOf(each), null);
        for (const [script, roots] of Object.entries(later)) {
          for (const each of roots) add(fileOf(each), script);
        }
        // The parts of the tools keep scripts with their own names, by which they are requested.
        for (const each of later.tools) scripts.delete(fileOf(each));
      }
      return scripts.get(id) ?? null;
    },
  };
}

const fileOf = (name: string): string => path.join(folder, name).replaceAll('\\', '/');
