// Keeps the files of one build, and those of older builds while a page still needs them. The build prepends BUILD;
// FILES, kept immediately, and LATER, kept after their first use, as { path: digest }; and PAGES, the first script of
// each page.
/* global BUILD, FILES, LATER, PAGES */
// Each release of the page on the same host has its own scope and files.
const SCOPE = self.registration.scope;
const OURS = `shapespline ${new URL(SCOPE).pathname} `;
const CACHE = OURS + BUILD;
const REPLY_MS = 3000;
const ENTRIES = new Map(Object.entries(PAGES).map(([file, entry]) => [new URL(file, SCOPE).href, entry]));
const LISTED = new Map(Object.entries({ ...FILES, ...LATER }).map(([file, digest]) => [new URL(file, SCOPE).href, digest]));

// A worker of a newer build waits until no page is open or a page asks for it, so open pages continue unchanged.
self.addEventListener('install', (event) => event.waitUntil(fill()));

self.addEventListener('activate', (event) => event.waitUntil(self.clients.claim().then(dropUnused)));

self.addEventListener('message', (event) => {
  if (event.data?.type === 'take over') event.waitUntil(self.skipWaiting());
  if (event.data?.type === 'holds') event.ports[0]?.postMessage(LISTED.has(event.data.url));
});

self.addEventListener('fetch', (event) => {
  const url = new URL(event.request.url);
  if (event.request.method !== 'GET' || !url.href.startsWith(SCOPE)) return;
  url.search = url.hash = '';
  event.respondWith(responseTo(event, url));
  if (event.request.mode === 'navigate') event.waitUntil(dropUnused());
});

async function digestOf(response) {
  const digest = await crypto.subtle.digest('SHA-256', await response.arrayBuffer());
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

// A host may answer a request for a missing file with its start page, or with another build's file: neither is kept.
// Hosts may modify the page itself, so it is recognised by its script.
async function isListed(href, response) {
  // Browsers run scripts and apply style sheets only with the right type.
  const type = { js: 'javascript', css: 'css' }[href.split('.').pop()] ?? '';
  if (!response.ok || !(response.headers.get('content-type') ?? '').includes(type)) return false;
  if (ENTRIES.has(href)) return (await response.clone().text()).includes(ENTRIES.get(href));
  return LISTED.get(href) === (await digestOf(response.clone()));
}

async function fill() {
  const cache = await caches.open(CACHE);
  const keep = async (file) => {
    const { href } = new URL(file, SCOPE);
    const response = await fetch(href, { cache: 'no-cache' });
    if (!(await isListed(href, response))) throw new Error(`${href} is not what the build made`);
    await cache.put(href, response);
  };
  await Promise.all(Object.keys(FILES).map(keep));
}

// Files with a digest in their name never change: they come from any cached build. Others are fetched first, so a new
// build appears immediately, and replace a damaged copy.
async function responseTo(event, url) {
  const named = url.pathname.includes('/assets/');
  const { kept, damaged } = named ? await match(url.href) : {};
  if (kept) return kept;
  try {
    // The damaged copy may come from the browser's own cache.
    const response = await fetch(event.request, damaged ? { cache: 'reload' } : {});
    if (LISTED.has(url.href)) event.waitUntil(keepUsed(url.href, response.clone()));
    if (damaged) event.waitUntil(tellOfRepair(event));
    return response;
  } catch (error) {
    const own = await match(url.href);
    const instead = own.kept ?? (event.request.mode === 'navigate' ? (await match(SCOPE)).kept : undefined);
    if (instead) return instead;
    throw error;
  }
}

// A page that is still loading receives the message once its script listens.
async function tellOfRepair({ clientId }) {
  const client = await self.clients.get(clientId);
  client?.postMessage({ type: 'repaired' });
}

async function keepUsed(href, response) {
  const cache = await caches.open(CACHE);
  const isWhole = (copy) => copy && isListed(href, copy).catch(() => false);
  if (await isWhole(await cache.match(href))) await response.body?.cancel();
  else if (await isWhole(response)) await cache.put(href, response).catch(() => undefined);
}

const ownCaches = async () => (await caches.keys()).filter((name) => name.startsWith(OURS));

// This build's cache first: others may hold another version of a file without a digest in its name. Only files with the
// right digest are used, because a damaged one would break the page on every visit.
async function match(href) {
  const others = (await ownCaches()).filter((name) => name !== CACHE);
  let damaged = false;
  for (const cacheName of [CACHE, ...others]) {
    const kept = (await caches.has(cacheName)) && (await caches.match(href, { cacheName }));
    if (!kept) continue;
    if (cacheName !== CACHE || (await isListed(href, kept).catch(() => false))) return { kept, damaged };
    damaged = true;
    await (await caches.open(CACHE)).delete(href);
  }
  return { damaged };
}

/** URL of a page's script, or null if the page does not reply. */
function scriptOf(client) {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = ({ data }) => resolve(data);
    setTimeout(resolve, REPLY_MS, null);
    client.postMessage({ type: 'which script' }, [port2]);
  });
}

// A page that does not reply may have been closed.
async function runsByThis(client) {
  const script = await scriptOf(client);
  return script === null ? !(await self.clients.get(client.id)) : LISTED.has(script);
}

// Older builds are deleted once every open page has reported that it runs this one; a page that does not reply may need
// any of them.
async function dropUnused() {
  const older = (await ownCaches()).filter((name) => name !== CACHE);
  // A waiting worker fills the cache of the next build.
  if (older.length === 0 || self.registration.installing || self.registration.waiting) return;
  const pages = await self.clients.matchAll({ type: 'window', includeUncontrolled: true });
  const unused = await Promise.all(pages.map(runsByThis));
  if (unused.every(Boolean)) await Promise.all(older.map((name) => caches.delete(name)));
}
