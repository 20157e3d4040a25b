import type { Plugin } from 'vite';

/**
 * gl-matrix makes a few of its functions by calling a function at load (`forEach = function ()
 * {…}()`). A bundler must treat the call as a side effect and keep it, with everything that it
 * calls. These calls have no side effects, so they are marked as pure, and unused functions can be
 * removed.
 */
export function pureGlMatrix(): Plugin {
  return {
    name: 'pure-gl-matrix',
    apply: 'build',
    transform: {
      filter: { id: /\/gl-matrix\/esm\/\w+\.js$/ },
      handler: (code) => ({ code: markPure(code), map: null }),
    },
  };
}

export function markPure(code: string): string {
  return code.replace(/^(export var \w+ = )(?=function \(\) \{)/gm, '$1/* @__PURE__ */ ');
}
