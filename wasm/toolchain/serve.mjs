// A static file server, optionally below a sub-path, with the headers that the manual recommends. --isolated
// also sends the two headers that let threads share memory.
//   node serve.mjs FOLDER [--port N] [--prefix /sub/path/] [--isolated]
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';

const types = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.webmanifest': 'application/manifest+json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.ico': 'image/x-icon',
  '.wasm': 'application/wasm',
  '.glb': 'model/gltf-binary',
  '.gltf': 'model/gltf+json',
  '.txt': 'text/plain; charset=utf-8',
};

const noFrames = "frame-ancestors 'self'";
/**
 * The policy of index.html's <meta>. The server also sends it as a header, because a worker follows only its script's
 * header.
 */
const policy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self' data:",
  "connect-src 'self'",
  "frame-src 'self'",
  "img-src 'self' blob: data:",
  "style-src 'self' 'unsafe-inline'",
  "media-src 'self' blob:",
  "manifest-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
  noFrames,
].join('; ');
const nosniff = { 'x-content-type-options': 'nosniff' };
/** Files are used only with the declared type and the page's permissions, and other hosts cannot frame them. */
export const guards = { ...nosniff, 'content-security-policy': policy };
/** For pages without a policy: those of the development server, tests and benchmarks. */
export const developmentGuards = { ...nosniff, 'content-security-policy': noFrames };
const isolation = { 'cross-origin-opener-policy': 'same-origin', 'cross-origin-embedder-policy': 'require-corp' };

// null if the file does not exist, or if a file is addressed like a folder (ENOTDIR).
function statsOf(file) {
  try {
    return statSync(file);
  } catch {
    return null;
  }
}

// The file of a URL: `{ file, size }`, or null if `folder` has none.
function locate(folder, prefix, url) {
  let wanted;
  try {
    wanted = decodeURIComponent(new URL(url, 'http://localhost').pathname);
  } catch {
    return null;
  }
  if (!wanted.startsWith(prefix) || wanted.includes('\0')) return null;
  const file = path.join(folder, wanted.slice(prefix.length));
  if (file !== folder && !file.startsWith(folder + path.sep)) return null;
  return [file, path.join(file, 'index.html')]
    .map((candidate) => ({ file: candidate, stats: statsOf(candidate) }))
    .find(({ stats }) => stats?.isFile());
}

/**
 * Serves `folder` on the first free port from `port` on, with `headers` on every response. Resolves to the page's URL
 * and the server.
 */
export async function serve(
  folder,
  { port = 4173, prefix = '/', tries = 50, isolated = false, headers = guards } = {},
) {
  const top = path.resolve(folder);
  const server = createServer((request, response) => {
    const found = ['GET', 'HEAD'].includes(request.method) ? locate(top, prefix, request.url) : null;
    if (!found) {
      response.writeHead(404, { 'content-type': 'text/plain', ...headers }).end('not found\n');
      return;
    }
    response.writeHead(200, {
      'content-type': types[path.extname(found.file)] ?? 'application/octet-stream',
      'content-length': found.stats.size,
      'cache-control': 'no-cache',
      ...headers,
      ...(isolated ? isolation : {}),
    });
    if (request.method === 'HEAD') response.end();
    else
      createReadStream(found.file)
        .on('error', () => response.destroy())
        .pipe(response);
  });
  for (let candidate = port; ; ++candidate) {
    try {
      await listen(server, candidate);
      return { url: `http://localhost:${candidate}${prefix}`, server };
    } catch (error) {
      if (error.code !== 'EADDRINUSE' || candidate + 1 >= port + tries) throw error;
    }
  }
}

function listen(server, port) {
  return new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen(port, 'localhost', () => {
      server.off('error', reject);
      resolve();
    });
  });
}

/** A currently free port. */
export async function freePort() {
  const server = createServer();
  await listen(server, 0);
  const { port } = server.address();
  await new Promise((closed) => server.close(closed));
  return port;
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      port: { type: 'string', default: '4173' },
      prefix: { type: 'string', default: '/' },
      isolated: { type: 'boolean', default: false },
    },
  });
  const { url } = await serve(positionals[0], { ...values, port: Number(values.port), tries: 1 });
  console.log(url);
}
