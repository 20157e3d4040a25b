import type { Plugin } from 'vite';

/** What the built page may load and run; everything else is refused. */
const directives: Readonly<Record<string, string>> = {
  'default-src': "'none'",
  // WebAssembly may be compiled, but text is never run as a script.
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
  // This policy provides the address of the workers; see src/app/run-task.ts.
  'trusted-types': 'skin-worker',
};

/**
 * Writes the content security policy into the built page, so that it holds on every host. The
 * server of `npm start` sends the page without it, because hot reloading needs inline styles.
 */
export function contentPolicy(): Plugin {
  const policy = Object.entries(directives).map((directive) => directive.join(' '));
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policy.join('; ')}" />`;
  const charset = '<meta charset="utf-8" />';
  return {
    name: 'content-policy',
    apply: 'build',
    transformIndexHtml(html) {
      // The policy applies to what follows it, so it comes before everything that loads something.
      const written = html.replace(charset, `${charset}\n    ${meta}`);
      if (written === html) throw new Error(`expected ${charset} in index.html`);
      return written;
    },
  };
}
