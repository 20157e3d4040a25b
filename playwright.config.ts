import { defineConfig } from '@playwright/test';
import { findBrowser, testFlags } from './tools/browser.mjs';
import { freePort } from './tools/free-port.ts';

const { env } = process;

// Every worker loads this file again, so the environment passes on what was found and chosen once.
env['TEST_BROWSER'] ??= findBrowser().path ?? 'playwright';
env['TEST_PORT'] ??= String(await freePort());
const browserFile = env['TEST_BROWSER'] === 'playwright' ? undefined : env['TEST_BROWSER'];

// The built app is served from a subfolder; an app that works there works at any path.
const folder = '/deep/sinew/';
const address = `http://127.0.0.1:${env['TEST_PORT']}${folder}`;
const inContinuousIntegration = Boolean(env['CI']);

export default defineConfig({
  testDir: 'e2e',
  outputDir: 'test-results',
  // The names contain no operating system, because the renderer is the same everywhere.
  snapshotPathTemplate: '{testDir}/expected/{arg}{ext}',
  fullyParallel: true,
  workers: 2,
  retries: 0,
  forbidOnly: inContinuousIntegration,
  globalTimeout: 14 * 60_000,
  // These limits guard against hanging, on a machine that has other work as well.
  timeout: 90_000,
  expect: {
    timeout: 20_000,
    toHaveScreenshot: { threshold: 0.1, maxDiffPixelRatio: 0.001, animations: 'disabled' },
  },
  use: {
    baseURL: address,
    viewport: { width: 960, height: 600 }, // small, because the CPU draws the pictures
    deviceScaleFactor: 1,
    locale: 'en-US',
    timezoneId: 'UTC',
    colorScheme: 'light',
    contextOptions: { reducedMotion: 'reduce' },
    // A trace costs time in every test; --trace=on records one when it is needed.
    trace: 'off',
    launchOptions: {
      ...(browserFile !== undefined && { executablePath: browserFile }),
      // Chromium's sandbox does not work for root, nor for anyone in many containers. The tests
      // open only our own pages.
      chromiumSandbox: false,
      args: testFlags,
    },
  },
  webServer: {
    command: `node node_modules/vite/bin/vite.js preview --base ${folder} --host 127.0.0.1 --port ${env['TEST_PORT']} --strictPort`,
    url: address,
    // A server that was left running may serve another version.
    reuseExistingServer: false,
  },
});
