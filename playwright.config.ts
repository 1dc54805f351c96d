// The real app, built and served as a person gets it, in Debian's Chromium.
import { defineConfig } from '@playwright/test';

const port = Number(process.env['FIATLUX_TEST_PORT'] ?? 4174); // another one where several runs share a machine
const address = `http://127.0.0.1:${port}/`;

export default defineConfig({
  testDir: 'tests/e2e',
  timeout: 90_000,
  expect: { timeout: 20_000 }, // a picture alone takes seconds where software draws it and others compute
  workers: 1,
  retries: 0,
  use: {
    baseURL: address,
    viewport: { width: 1280, height: 800 },
    serviceWorkers: 'block', // but for the test of visits without a connection
    // Somebody who was here before: the light is there at once, and nothing moves that nobody has asked to.
    storageState: {
      cookies: [],
      origins: [
        { origin: new URL(address).origin, localStorage: [{ name: 'fiatlux.room', value: 'office' }] },
      ],
    },
    launchOptions: {
      executablePath: '/usr/bin/chromium',
      args: [
        '--no-sandbox',
        '--use-angle=swiftshader',
        '--enable-unsafe-swiftshader',
        '--disable-background-networking',
        '--disable-gpu-rasterization', // without a graphics card the page is painted sooner than OpenGL is emulated
      ],
    },
  },
  webServer: {
    command: `npx vite preview --port ${port} --strictPort --host 127.0.0.1`,
    url: address,
    reuseExistingServer: false,
  },
});
