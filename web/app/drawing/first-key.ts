/** While large files are opened, what is open rests dimmed until the first key of the new motion takes its place. */
import type { LoadedKeys } from '../session/workspace.ts';
import type { Seen } from '../view/view-state.ts';

export interface FirstKeyParts {
  /** Resolves when what is open no longer asks for the processor; until `resume`. */
  rest(): Promise<void>;
  resume(): void;
  /** Resolves once the first key is seen. */
  show(opening: LoadedKeys): Promise<void>;
  /** What is open is shown again. */
  hide(): void;
  onSeen(seen: Seen): void;
}

export class FirstKey {
  /** Another promise for each opening; null while there is none. */
  private rested: Promise<void> | null = null;
  /** It is on the screen, or about to be. */
  isShown = false;

  constructor(private readonly parts: FirstKeyParts) {}

  /** Files are being read. */
  begin(): void {
    this.parts.onSeen('dimmed');
    this.rested = this.parts.rest();
  }

  async show(opening: LoadedKeys): Promise<void> {
    // Compressed files show only now that they are large.
    this.rested ??= this.parts.rest();
    const { rested } = this;
    await rested;
    if (this.rested !== rested) return;
    this.isShown = true;
    await this.parts.show(opening);
    if (this.rested === rested) this.parts.onSeen('first key');
  }

  /** It is open now. */
  settle(): void {
    this.leave(() => undefined);
  }

  /** It is small, it will not be opened, or what is open is asked for. */
  end(): void {
    this.leave(this.parts.hide);
  }

  private leave(hide: () => void): void {
    if (!this.rested) return;
    this.rested = null;
    if (this.isShown) hide();
    this.isShown = false;
    this.parts.resume();
    this.parts.onSeen('open');
  }
}
