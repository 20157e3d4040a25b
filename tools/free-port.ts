import { createServer } from 'node:net';

/** Returns a port that nothing on this machine uses at the moment. */
export function freePort(): Promise<number> {
  return new Promise((resolve, reject) => {
    const server = createServer();
    server.once('error', reject);
    server.listen(0, '127.0.0.1', () => {
      const found = server.address();
      server.close(() => {
        if (found === null || typeof found === 'string') reject(new Error('no free port'));
        else resolve(found.port);
      });
    });
  });
}
