import type { Plugin } from 'vite';

/** What the built page may load and run; everything that is not named here is refused. */
const directives: Readonly<Record<string, string>> = {
  'default-src': "'none'",
  // WebAssembly may be compiled; text is never run as a script.
  'script-src': "'self' 'wasm-unsafe-eval'",
  'style-src': "'self'",
  'img-src': "'self' blob: data:",
  'media-src': "'self' blob:",
  'connect-src': "'self'",
  'worker-src': "'self'",
  // The icons of lil-gui are a font within its style sheet.
  'font-src': "'self' data:",
  'manifest-src': "'self'",
  'base-uri': "'none'",
  'form-action': "'none'",
  'require-trusted-types-for': "'script'",
  // It gives the address of the workers: src/app/run-task.ts.
  'trusted-types': 'skin-worker',
};

/**
 * Writes the content security policy into the built page, where it holds on every host. The server of
 * `npm start` sends the page without it, because hot reloading needs styles within the page.
 */
export function contentPolicy(): Plugin {
  const policy = Object.entries(directives).map((directive) => directive.join(' '));
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policy.join('; ')}" />`;
  const charset = '<meta charset="utf-8" />';
  return {
    name: 'content-policy',
    apply: 'build',
    transformIndexHtml(html) {
      // It holds for what comes after it, so it stands before everything that loads something.
      const written = html.replace(charset, `${charset}\n    ${meta}`);
      if (written === html) throw new Error(`expected ${charset} in index.html`);
      return written;
    },
  };
}
