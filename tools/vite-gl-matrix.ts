import type { Plugin } from 'vite';

/**
 * gl-matrix makes a few of its functions by calling one at load (`forEach = function () {…}()`), which
 * a bundler must take for an effect and keep, with all that it calls. They have none: marked as pure,
 * those that nobody uses are left out.
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
