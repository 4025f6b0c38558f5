/**
 * Starts the service worker of a built page. If it cannot run (no https, forbidden storage, a sandboxed frame), the
 * page works without it.
 */

/** Shortest time between two checks for a newer build when a page becomes visible again. */
const ASK_EVERY_MS = 3_600_000;

export interface OfflineEvents {
  /** Another build is ready; `reload` opens it. */
  onNewVersion(reload: () => void): void;
  /** A stored file was damaged and has been fetched again. */
  onRepaired(sentence: string): void;
}

const REPAIRED = 'A file stored by this browser was damaged. It was fetched again.';

/** The service worker fetches and compiles the whole build, so it waits until `after` and until the page is idle. */
export function registerServiceWorker(
  { onNewVersion, onRepaired }: OfflineEvents,
  after: Promise<unknown> = Promise.resolve(),
): void {
  const serviceWorker = import.meta.env.PROD && serviceWorkerOfPage();
  if (!serviceWorker) return;
  let repaired = false;
  serviceWorker.addEventListener('message', ({ data, ports }: MessageEvent<{ type?: string }>) => {
    if (data.type === 'which script') ports[0]?.postMessage(ownScript());
    if (data.type === 'repaired' && !repaired) {
      repaired = true;
      onRepaired(REPAIRED);
    }
  });
  serviceWorker.startMessages();
  Promise.allSettled([after, loaded()])
    .then(() => serviceWorker.register(new URL('./sw.js', document.baseURI)))
    .then((registration) => follow(registration, onNewVersion))
    .catch(() => undefined);
}

/** A frame sandboxed without allow-same-origin throws when it is asked. */
function serviceWorkerOfPage(): ServiceWorkerContainer | undefined {
  try {
    return navigator.serviceWorker;
  } catch {
    return undefined;
  }
}

const loaded = (): Promise<unknown> =>
  document.readyState === 'complete'
    ? Promise.resolve()
    : new Promise((resolve) => window.addEventListener('load', resolve, { once: true }));

const PAGE_MS = 2000;

/** Whether the host now has another build of this page, so files of this build may be gone. */
export async function isReplaced(): Promise<boolean> {
  const own = ownScript().split('/').at(-1);
  try {
    const { pathname } = new URL(document.baseURI);
    const response = await fetch(pathname, { cache: 'no-cache', signal: AbortSignal.timeout(PAGE_MS) });
    const page = response.ok ? await response.text() : '';
    // Networks may answer with a page of their own.
    return Boolean(own) && page.includes('<title>shapespline') && !page.includes(own!);
  } catch {
    return false;
  }
}

const ownScript = (): string => document.querySelector<HTMLScriptElement>('script[type="module"][src]')?.src ?? '';

function follow(registration: ServiceWorkerRegistration, onNewVersion: (reload: () => void) => void): void {
  const offer = async (worker: ServiceWorker): Promise<void> => {
    // Without an active worker, this is the first visit. A page loaded from the new build needs no reload.
    if (!navigator.serviceWorker.controller || (await holds(worker, ownScript()))) return;
    onNewVersion(() => {
      navigator.serviceWorker.addEventListener('controllerchange', () => location.reload(), { once: true });
      worker.postMessage({ type: 'take over' });
      // Another page may already have activated it.
      if (worker.state === 'activated') location.reload();
    });
  };
  const watch = (worker: ServiceWorker | null): void => {
    if (worker?.state === 'installed') void offer(worker);
    else worker?.addEventListener('statechange', () => worker.state === 'installed' && void offer(worker));
  };
  watch(registration.waiting ?? registration.installing);
  registration.addEventListener('updatefound', () => watch(registration.installing));
  let asked = Date.now();
  document.addEventListener('visibilitychange', () => {
    if (document.hidden || Date.now() - asked < ASK_EVERY_MS) return;
    asked = Date.now();
    registration.update().catch(() => undefined);
  });
}

/** Whether the build of this worker has the file. */
function holds(worker: ServiceWorker, url: string): Promise<boolean> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = ({ data }: MessageEvent<boolean>) => resolve(data);
    worker.postMessage({ type: 'holds', url }, [port2]);
  });
}
