/** What the page says of work: its progress, what it came to, what went wrong. */
import { isCancelled } from '../../engine/api/errors.ts';
import type { Progress } from '../../engine/api/types.ts';
import { createToast } from '../../ui/messages.ts';
import type { ToastAction } from '../../ui/messages.ts';
import { errorMessageOf } from './error-message.ts';
import type { ViewStateHolder } from './view-state.ts';

export interface Feedback {
  toast: HTMLElement;
  say(text: string, action?: ToastAction): void;
  /** Buttons of earlier messages no longer do what they say. */
  withdraw(): void;
  /** Nothing was said. */
  clear(): void;
  /** Something else is asked for: what went wrong before is of no interest. */
  onStart(): void;
  onWorking(working: Progress | null): void;
  onError(error: unknown): void;
}

export function createFeedback(viewState: ViewStateHolder): Feedback {
  const toast = createToast();
  return {
    toast: toast.element,
    say: toast.say,
    withdraw: toast.withdraw,
    clear: toast.clear,
    onStart: () => viewState.change({ errorMessage: null }),
    onWorking: (working) => viewState.change({ working }),
    onError(error) {
      if (!isCancelled(error)) viewState.change({ errorMessage: errorMessageOf(error) });
    },
  };
}
