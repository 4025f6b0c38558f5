/** Messages about work: progress, results and errors. */
import { isCancelled } from '../../engine/api/errors.ts';
import type { Progress } from '../../engine/api/types.ts';
import { isReplaced } from '../../offline/register.ts';
import { createToast } from '../../ui/messages.ts';
import type { ErrorMessage, ToastAction } from '../../ui/messages.ts';
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

const REPLACED =
  'There is a new version of this page. Reload it to go on. Remembered files and samples keep your edits.';

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
      if (isCancelled(error)) return;
      const message = errorMessageOf(error);
      const show = (errorMessage: ErrorMessage): void => viewState.change({ errorMessage });
      // The host may have replaced the files that this page has not loaded yet.
      if (message.retry) void isReplaced().then((is) => show(is ? { ...message, message: REPLACED } : message));
      else show(message);
    },
  };
}
