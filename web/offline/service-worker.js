// Keeps the files of one build. FILES and BUILD are put in front of this text by the build.
/* global FILES, BUILD */
// Another release of the page may stand beside this one on the same host: each keeps its own.
const OURS = `shapespline ${new URL(self.registration.scope).pathname} `;
const CACHE = OURS + BUILD;

self.addEventListener('install', (event) => {
  event.waitUntil(fill().then(() => self.skipWaiting()));
});

self.addEventListener('activate', (event) => {
  event.waitUntil(dropOthers().then(() => self.clients.claim()));
});

self.addEventListener('fetch', (event) => {
  const url = new URL(event.request.url);
  if (event.request.method !== 'GET' || url.origin !== self.location.origin || !url.href.startsWith(self.registration.scope)) return;
  event.respondWith(answer(event, url));
});

async function fill() {
  const cache = await caches.open(CACHE);
  await cache.addAll(FILES.map((file) => new Request(file, { cache: 'no-cache' })));
}

async function dropOthers() {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith(OURS) && name !== CACHE).map((name) => caches.delete(name)));
}

// Files with a hash in their name never change: those that are not on the list are kept, too, once they were used. The others are
// asked for first, so that a new build is seen at once.
async function answer(event, url) {
  const { request } = event;
  const cache = await caches.open(CACHE);
  const kept = await cache.match(request, { ignoreSearch: true });
  const hashed = /\/assets\//.test(url.pathname);
  if (kept && hashed) return kept;
  try {
    const response = await fetch(request);
    if (hashed && response.ok) event.waitUntil(cache.put(request, response.clone()).catch(() => undefined));
    return response;
  } catch (error) {
    const page = request.mode === 'navigate' ? await cache.match('./') : undefined;
    if (kept ?? page) return kept ?? page;
    throw error;
  }
}
