// The static site: relative addresses, so that dist/ works from any folder of any static host.
import { defineConfig } from 'vite';

/** Names the app's own script in the page, so that it is fetched along with the first one and not after it. */
const announceApp = {
  name: 'announce-app',
  transformIndexHtml: {
    order: 'post',
    handler(_html, { bundle }) {
      const app = Object.values(bundle ?? {}).find(({ facadeModuleId }) =>
        facadeModuleId?.endsWith('/start.tsx'),
      );
      const attrs = { rel: 'modulepreload', crossorigin: true, href: `./${app?.fileName}` };
      return app ? [{ tag: 'link', attrs, injectTo: 'head' }] : [];
    },
  },
};

export default defineConfig({
  root: 'web',
  base: './',
  plugins: [announceApp],
  publicDir: '../public',
  // three.js alone is larger than the size above which Vite warns.
  build: { outDir: '../dist', emptyOutDir: true, target: 'es2022', chunkSizeWarningLimit: 1000 },
  worker: { format: 'es' },
});
