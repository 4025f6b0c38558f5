/** The way into the guide, which is loaded when somebody turns to it. */
import type { Guide, GuideParts } from './guide.ts';
import type { Facts } from './guide-page.ts';

export interface GuideDoor {
  /** Turns to the page of a link; false where there is none. */
  open(fragment: string): Promise<boolean>;
  /** Leaves it; false where it is not open. */
  close(): boolean;
  onOpened(): void;
  /** Asked only while it is open. */
  follow(facts: () => Facts | null): void;
}

export function createGuideDoor(parts: GuideParts): GuideDoor {
  let guide: Guide | null = null;
  return {
    async open(fragment) {
      const { createGuide } = await import('./guide.ts');
      guide ??= createGuide(parts);
      return guide.open(fragment);
    },
    close() {
      if (!guide?.isOpen) return false;
      void guide.close();
      return true;
    },
    onOpened: () => guide?.onOpened(),
    follow(facts) {
      if (guide?.isOpen) guide.setFacts(facts());
    },
  };
}
