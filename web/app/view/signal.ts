/** A notification whose sender exists before its listener. */
export interface Signal {
  send(): void;
  /** Replaces the listener. Nothing listens before the first call. */
  listen(listener: () => void): void;
}

export function createSignal(): Signal {
  let heard = (): void => undefined;
  return {
    send: () => heard(),
    listen(listener) {
      heard = listener;
    },
  };
}
