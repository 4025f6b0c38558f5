/** What the page says of work: its progress, what it came to, what went wrong. */
import { isCancelled } from '../../engine/api/errors.ts';
import type { Progress } from '../../engine/api/types.ts';
import { createToast } from '../../ui/messages.ts';
import { errorMessageOf } from './error-message.ts';
import type { ViewStateHolder } from './view-state.ts';

export interface Feedback {
  toast: HTMLElement;
  say(text: string): void;
  /** Something else is asked for: what went wrong before is of no interest. */
  onStart(): void;
  onWorking(working: Progress | null): void;
  onError(error: unknown): void;
}

/** Milliseconds: drawing the page more often takes the processors from the work, where that is done in software. */
const PROGRESS_MS = 150;

export function createFeedback(viewState: ViewStateHolder): Feedback {
  const toast = createToast();
  let said: { stage: string; at: number } | null = null;
  return {
    toast: toast.element,
    say: toast.say,
    onStart: () => viewState.change({ errorMessage: null }),
    onWorking(working) {
      const at = performance.now();
      if (working && working.stage === said?.stage && at < said.at + PROGRESS_MS) return;
      said = working && { stage: working.stage, at };
      viewState.change({ working });
    },
    onError(error) {
      if (!isCancelled(error)) viewState.change({ errorMessage: errorMessageOf(error) });
    },
  };
}
