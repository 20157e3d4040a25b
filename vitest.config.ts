import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    environment: 'node',
    include: ['tests/**/*.test.ts'],
    setupFiles: ['tests/support/quick-equality.ts'],
    // Modules of the product keep no state except scratch memory, so test files can share a process.
    // That halves the time, and would reveal state that leaks.
    isolate: false,
    // The default leaves one core free, which would be half of a machine with two cores.
    maxWorkers: '100%',
    // This guards against hanging; it is about twenty times what the slowest test takes.
    testTimeout: 60_000,
  },
});
