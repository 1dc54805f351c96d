// The static site: relative addresses, so that dist/ works from any folder of any static host.
import { createHash } from 'node:crypto';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

/** Names the scripts of the app in the page, so that they are fetched along with the first one and not after it. */
const announceApp = {
  name: 'announce-app',
  transformIndexHtml: {
    order: 'post',
    handler(html, { bundle }) {
      const chunks = bundle ?? {};
      const start = Object.values(chunks).find(({ moduleIds }) =>
        moduleIds?.some((id) => id.endsWith('/start.tsx')),
      );
      const needed = new Set(start ? [start.fileName] : []);
      for (const file of needed) chunks[file].imports.forEach((each) => needed.add(each));
      return [...needed]
        .filter((file) => !html.includes(file))
        .map((file) => {
          const attrs = { rel: 'modulepreload', crossorigin: true, href: `./${file}` };
          return { tag: 'link', attrs, injectTo: 'head' };
        });
    },
  },
};

/**
 * What the first picture needs, in few files: a browser asks a host for six at a time, and the room waits in that queue.
 * A group takes along all that its module imports.
 */
const fewChunks = {
  groups: [
    { name: 'first', test: /web[\\/]main\.ts$/, priority: 3 },
    { name: 'three', test: /node_modules[\\/]three[\\/]build/, priority: 2 },
    { name: 'app', test: /web[\\/]start\.tsx$/, priority: 1 },
  ],
};

/** Adds the service worker (web/offline/service-worker.ts) to a build and tells it what the build is made of. */
const keepOffline = {
  name: 'keep-offline',
  apply: 'build',
  buildStart() {
    const id = fileURLToPath(new URL('web/offline/service-worker.ts', import.meta.url));
    this.emitFile({ type: 'chunk', id, fileName: 'service-worker.js' });
  },
  generateBundle: {
    order: 'post',
    handler(_options, bundle) {
      const worker = bundle['service-worker.js'];
      // Seven megabytes that few people need are kept once they were used, like rooms.
      const isKept = (name) =>
        name !== worker.fileName && !name.endsWith('.html') && !/\bweb-ifc\b/.test(name);
      const files = Object.keys(bundle).filter(isKept);
      const entry = Object.values(bundle).find(
        ({ isEntry, fileName }) => isEntry && fileName !== worker.fileName,
      );
      const id = createHash('sha256')
        .update(JSON.stringify([files.sort(), worker.code]))
        .digest('hex')
        .slice(0, 16);
      const build = { id, files, entry: entry.fileName };
      worker.code = `const fiatluxBuild = ${JSON.stringify(build)};\n${worker.code}`;
    },
  },
};

export default defineConfig({
  root: 'web',
  base: './',
  plugins: [announceApp, keepOffline],
  publicDir: '../public',
  // three.js alone is larger than the size above which Vite warns.
  build: {
    outDir: '../dist',
    emptyOutDir: true,
    target: 'es2022',
    chunkSizeWarningLimit: 1000,
    rolldownOptions: { output: { codeSplitting: fewChunks } },
  },
  worker: { format: 'es' },
});
