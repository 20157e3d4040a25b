import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    environment: 'node',
    include: ['tests/**/*.test.ts'],
    // The product keeps no state in its modules but scratch, so that files may share a process:
    // that halves the time, and would show a state that leaks.
    isolate: false,
    // By itself it leaves one core free: on two that would be all of them but one.
    maxWorkers: '100%',
    // A guard against hanging, some twenty times what the slowest test takes.
    testTimeout: 60_000,
  },
});
