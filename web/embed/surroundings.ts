/** What an element has to know of the page around it. */

export interface SurroundingsEvents {
  /** Near enough to the view that what it shows should be fetched. */
  onNear(near: boolean): void;
  onSeen(seen: boolean): void;
  /** Other children, or other words in them. */
  onChildren(): void;
  /** The reader has chosen light or dark, or more or less motion. */
  onPreference(): void;
}

/** How far outside of the view what is lazy is fetched. */
const NEAR = '256px';
const DARK = '(prefers-color-scheme: dark)';
const LESS_MOTION = '(prefers-reduced-motion: reduce)';

export const lessMotion = (): boolean => matchMedia(LESS_MOTION).matches;

/** As the page's `color-scheme` has it, which may leave it to the reader. */
export function isDark({ colorScheme }: CSSStyleDeclaration): boolean {
  const [light, dark] = [/light/, /dark/].map((word) => word.test(colorScheme));
  return dark! && (!light || matchMedia(DARK).matches);
}

/** Returns what ends it. */
export function watch(element: Element, events: SurroundingsEvents): () => void {
  const near = new IntersectionObserver((entries) => events.onNear(entries.at(-1)!.isIntersecting), {
    rootMargin: NEAR,
  });
  const seen = new IntersectionObserver((entries) => events.onSeen(entries.at(-1)!.isIntersecting));
  for (const observer of [near, seen]) observer.observe(element);
  const children = new MutationObserver(() => events.onChildren());
  children.observe(element, { childList: true, subtree: true, attributes: true, attributeFilter: ['src', 'time'] });
  const preferences = [DARK, LESS_MOTION].map((query) => matchMedia(query));
  for (const preference of preferences) preference.addEventListener('change', events.onPreference);
  return () => {
    for (const observer of [near, seen, children]) observer.disconnect();
    for (const preference of preferences) preference.removeEventListener('change', events.onPreference);
  };
}
