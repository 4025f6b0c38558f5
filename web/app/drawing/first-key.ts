/** While large files are being opened, dims the open shape until the first key of the new motion is shown. */
import type { LoadedKeys } from '../session/workspace.ts';
import type { Seen } from '../view/view-state.ts';

export interface FirstKeyParts {
  /** Resolves when the open shape no longer uses the processor; lasts until `resume`. */
  rest(): Promise<void>;
  resume(): void;
  /** Resolves once the first key is drawn. */
  show(opening: LoadedKeys): Promise<void>;
  /** Shows the open shape again. */
  hide(): void;
  onSeen(seen: Seen): void;
}

export class FirstKey {
  /** One promise per opening; null when nothing is being opened. */
  private rested: Promise<void> | null = null;
  /** The first key is on the screen, or about to be. */
  isShown = false;

  constructor(private readonly parts: FirstKeyParts) {}

  /** Call when reading of files starts. */
  begin(): void {
    this.parts.onSeen('dimmed');
    this.rested = this.parts.rest();
  }

  async show(opening: LoadedKeys): Promise<void> {
    // The size of compressed files is known only now.
    this.rested ??= this.parts.rest();
    const { rested } = this;
    await rested;
    if (this.rested !== rested) return;
    this.isShown = true;
    await this.parts.show(opening);
    if (this.rested === rested) this.parts.onSeen('first key');
  }

  /** Call when the files are open. */
  settle(): void {
    this.leave(() => undefined);
  }

  /** Call when the files are small or will not be opened, or the open shape is requested. */
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
