import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import path from 'node:path';

const types: Readonly<Record<string, string>> = {
  '.css': 'text/css',
  '.gz': 'application/gzip',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};

export interface BenchServer {
  readonly address: string;
  close(): void;
}

/**
 * Serves the files of a folder to isolated pages, whose clock has steps of 5 microseconds. Nothing
 * is cached. An address NAME.page is a bare page that runs NAME.js.
 */
export async function serve(folder: string): Promise<BenchServer> {
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://bench');
    const name = pathname.endsWith('/') ? `${pathname}index.html` : pathname;
    response.setHeader('Cache-Control', 'no-store');
    response.setHeader('Cross-Origin-Opener-Policy', 'same-origin');
    response.setHeader('Cross-Origin-Embedder-Policy', 'require-corp');
    if (name.endsWith('.page')) {
      response.setHeader('Content-Type', 'text/html');
      response.end(barePage(path.basename(name, '.page')));
      return;
    }
    readFile(path.join(folder, path.normalize(name))).then(
      (bytes) => {
        response.setHeader('Content-Type', types[path.extname(name)] ?? 'application/octet-stream');
        response.end(bytes);
      },
      () => {
        response.statusCode = 404;
        response.end();
      },
    );
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const found = server.address();
  if (found === null || typeof found === 'string') throw new Error('the server has no port');
  return {
    address: `http://127.0.0.1:${found.port}`,
    close: () => server.close(),
  };
}

function barePage(script: string): string {
  return `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,"><style>body { margin: 0 }</style><script type="module" src="./${script}.js"></script>`;
}
