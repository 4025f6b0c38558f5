/** The way into the guide, which is loaded when somebody turns to it. */
import type { Plot } from '../../model/state.ts';
import type { Guide, GuideParts } from './guide.ts';
import type { Facts } from './guide-page.ts';

export interface GuideDoor {
  /** Turns to the page of a link; false where there is none. */
  open(fragment: string): Promise<boolean>;
  /** Leaves it; false where it is not open. */
  close(): boolean;
  /** Leaves it where a page of it is being opened; true where that is what is under way, or the way back is. */
  cancel(): boolean;
  /** The plot that the page on show speaks of, or null. */
  readonly plot: Plot | null;
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
    cancel() {
      if (guide?.isTurning) void guide.close();
      return guide?.isTurning === true || guide?.isReturning === true;
    },
    get plot() {
      return guide?.plot ?? null;
    },
    onOpened: () => guide?.onOpened(),
    follow(facts) {
      if (guide?.isOpen) guide.setFacts(facts());
    },
  };
}
