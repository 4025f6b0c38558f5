/** Messages about work: progress, results and errors. */
import { isCancelled } from '../../engine/api/errors.ts';
import type { Progress } from '../../engine/api/types.ts';
import { createToast } from '../../ui/messages.ts';
import type { ToastAction } from '../../ui/messages.ts';
import { errorMessageOf } from './error-message.ts';
import type { ViewStateHolder } from './view-state.ts';

export interface Feedback {
  toast: HTMLElement;
  say(text: string, action?: ToastAction): void;
  /** Removes buttons of earlier messages that no longer apply. */
  withdraw(): void;
  /** Clears all messages. */
  clear(): void;
  /** Another request starts, so earlier errors no longer matter. */
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
