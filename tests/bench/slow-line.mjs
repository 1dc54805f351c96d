/**
 * Serves dist/ over a slow line: one rate for all that is on its way, whoever asked for it, and a delay before each
 * answer. (The browser's own emulation gives each worker a line of its own, and what is fetched first is fetched by one.)
 * Scripts, styles and Wasm go compressed, as hosts send them.
 */
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { gzipSync } from 'node:zlib';

const types = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
};
const piece = 8 << 10; // bytes that go out at a time

/** A line on which pieces wait their turn: `bytesPerSecond` together, each after `delay` ms of its own. */
class Line {
  constructor(bytesPerSecond) {
    this.bytesPerSecond = bytesPerSecond;
    this.free = 0; // ms, when the last piece is through
  }

  async take(bytes) {
    const now = performance.now();
    this.free = Math.max(this.free, now) + (1e3 * bytes) / this.bytesPerSecond;
    await wait(this.free - now);
  }
}

/** What a host sends for an address; null where it has nothing. */
async function answerOf(folder, url) {
  const name = decodeURIComponent(new URL(url, 'http://host').pathname);
  const file = path.join(folder, name.endsWith('/') ? `${name}index.html` : name);
  if (!file.startsWith(folder)) return null;
  const bytes = await readFile(file).catch(() => null);
  const type = types[path.extname(file)];
  if (!bytes || !type) return bytes && { bytes, headers: { 'content-type': 'application/octet-stream' } };
  return { bytes: gzipSync(bytes), headers: { 'content-type': type, 'content-encoding': 'gzip' } };
}

async function send(line, response, bytes) {
  for (let at = 0; at < bytes.length && !response.destroyed; at += piece) {
    const part = bytes.subarray(at, at + piece);
    await line.take(part.length);
    response.write(part);
  }
  response.end();
}

/** Serves a folder while `use` runs. */
export async function onSlowLine({ folder, bytesPerSecond, delay }, use) {
  const line = new Line(bytesPerSecond);
  const server = createServer(async (request, response) => {
    const [answer] = await Promise.all([answerOf(folder, request.url), wait(delay)]);
    response.writeHead(
      answer ? 200 : 404,
      answer && { ...answer.headers, 'content-length': answer.bytes.length },
    );
    await send(line, response, answer?.bytes ?? Buffer.alloc(0));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  try {
    return await use(`http://127.0.0.1:${server.address().port}/`);
  } finally {
    server.closeAllConnections();
    server.close();
  }
}
