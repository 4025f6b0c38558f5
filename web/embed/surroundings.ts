/** Facts about the page around an element. */

export interface SurroundingsEvents {
  /** Close enough to the view to fetch the content. */
  onNear(near: boolean): void;
  onSeen(seen: boolean): void;
  /** Children were added or removed, or their `src` or `time` changed. */
  onChildren(): void;
  /** The user prefers another colour scheme, or more or less motion. */
  onPreference(): void;
}

/** Distance from the view at which lazy content is fetched. */
const NEAR = '256px';
const DARK = '(prefers-color-scheme: dark)';
const LESS_MOTION = '(prefers-reduced-motion: reduce)';

/** Pages without a screen, such as tests with jsdom, have no preferences, and everything counts as visible. */
const query = (words: string): MediaQueryList | null => globalThis.matchMedia?.(words) ?? null;

export const lessMotion = (): boolean => query(LESS_MOTION)?.matches === true;

/** Follows the page's `color-scheme`, which may leave the choice to the user. */
export function isDark({ colorScheme }: CSSStyleDeclaration): boolean {
  const [light, dark] = [/light/, /dark/].map((word) => word.test(colorScheme));
  return dark! && (!light || query(DARK)?.matches === true);
}

/** Returns a function that stops watching. */
export function watch(element: Element, events: SurroundingsEvents): () => void {
  const ends = [
    whileInView(element, NEAR, events.onNear),
    whileInView(element, '0px', events.onSeen),
    onChange(element, events.onChildren),
  ];
  const preferences = [DARK, LESS_MOTION].map(query);
  for (const preference of preferences) preference?.addEventListener('change', events.onPreference);
  return () => {
    for (const end of ends) end();
    for (const preference of preferences) preference?.removeEventListener('change', events.onPreference);
  };
}

/** Each returns a function that stops watching. */
function whileInView(element: Element, rootMargin: string, tell: (inView: boolean) => void): () => void {
  if (!globalThis.IntersectionObserver) {
    const timer = setTimeout(tell, 0, true);
    return () => clearTimeout(timer);
  }
  const observer = new IntersectionObserver((entries) => tell(entries.at(-1)!.isIntersecting), { rootMargin });
  observer.observe(element);
  return () => observer.disconnect();
}

function onChange(element: Element, tell: () => void): () => void {
  if (!globalThis.MutationObserver) return () => undefined;
  const observer = new MutationObserver(tell);
  observer.observe(element, { childList: true, subtree: true, attributes: true, attributeFilter: ['src', 'time'] });
  return () => observer.disconnect();
}
