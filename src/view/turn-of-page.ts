/**
 * Lets the page draw and answer the user. A timer would do the same, but browsers slow timers down
 * to one a second in a tab that is out of sight.
 */
export function turnOfPage(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
