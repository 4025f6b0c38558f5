/** Opens requested content: reads it, makes its motion, and replaces the open content. */
import type { Engine } from '../../engine/api/api.ts';
import { isCancelled } from '../../engine/api/errors.ts';
import type { InputFile, Progress } from '../../engine/api/types.ts';
import type { InsertPosition } from '../../model/edits.ts';
import { orientationStep, reorientedDoc } from '../../model/orientation.ts';
import type { Orientation } from '../../model/orientation.ts';
import type { End } from '../../model/speeds.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import { OpenHistory } from '../storage/open-history.ts';
import type { Step } from '../storage/open-history.ts';
import type { StoredProject } from '../storage/project-shelf.ts';
import { currentSnapshot } from '../storage/snapshot.ts';
import type { Snapshot } from '../storage/snapshot.ts';
import type { Store } from '../session/store.ts';
import type { LoadedKeys, Workspace } from '../session/workspace.ts';
import { addPoses, takeTangent } from './add-poses.ts';
import {
  animationRequest,
  leftRequest,
  momentsRequest,
  objectsRequest,
  orientationOf,
  pickedRequest,
  sampleRequest,
  turnRequest,
} from './open-request.ts';
import type { OpenRequest, Present } from './open-request.ts';
import { openedState, startOf } from './start-state.ts';
import type { StartState } from './start-state.ts';
import { ignoredValues } from './permalink.ts';
import type { Permalink } from './permalink.ts';
import type { Sample } from './samples.ts';
import { fetchSample } from './samples.ts';

/** The new content, before it is in the state. The camera comes from a link or an earlier visit. */
export interface OpenResult extends LoadedKeys, StartState, Pick<OpenRequest, 'source' | 'picked' | 'stays'> {
  /** Orientation of files that do not specify it. */
  orientation: Orientation | null;
  /** The files were stood up because of their shapes. */
  stoodUp: boolean;
  /** The chosen objects of the files; empty for all. */
  objects: readonly string[];
}

export interface OpenerParts {
  engine: Engine;
  store: Store;
  workspace: Workspace;
  samples(): readonly Sample[];
  reducedMotion(): boolean;
  say(text: string): void;
  /** Another request starts, so earlier errors no longer matter. */
  onStart(): void;
  onOpened(opened: OpenResult): void;
  /** The files were read again for the same document, and the motions must be made again. */
  onRead(): void;
  /** Progress of reading additional poses; the workspace reports imports. */
  onWorking(working: Progress | null): void;
  onError(error: unknown): void;
}

/** Methods that open content resolve to whether it is open now. They reject only if their comments state it. */
export class Opener {
  readonly history = new OpenHistory();
  /** Number of requests so far. */
  asks = 0;
  private fetching = new AbortController();
  private readonly running = new Set<Promise<unknown>>();

  constructor(private readonly parts: OpenerParts) {}

  get busy(): boolean {
    return this.running.size > 0;
  }

  /** Resolves when nothing is being opened. */
  async idle(): Promise<void> {
    while (this.busy) await Promise.all(this.running);
  }

  /** `files`: the sample's files, if already being fetched. `step`: history step for undo; null for none. */
  sample(
    id: string,
    link: Permalink | null = null,
    files: Promise<InputFile[]> | null = null,
    step: Step | null = 'on',
  ): Promise<boolean> {
    return this.guarded(async () => {
      const sample = this.parts.samples().find((one) => one.id === id);
      if (!sample) throw new Error(`There is no sample named “${id}”. Choose one from the list.`);
      if (!sample.made) this.parts.engine.warmFiles();
      const input = await this.fetched((signal) => files ?? fetchSample(sample, signal));
      if (!input) return false;
      const request = sampleRequest(sample, input, link, step);
      return this.meet(request).catch(async (error: unknown) => {
        // A sample must open even if the engine refuses a part of the link.
        const final = isCancelled(error) || (error as { code?: unknown }).code === 'not-loaded';
        if (!link || final || !(await this.meet({ ...request, link: null }))) throw error;
        this.parts.onError(error);
        return true;
      });
    });
  }

  /** Opens a link's content without an undo step. */
  show(link: Permalink): Promise<boolean> {
    return this.sample(link.sample, link, null, null);
  }

  /** Runs `work` on the files, unless other files are requested before they are ready. */
  run(given: PickedFile[] | Promise<PickedFile[]>, work: (files: PickedFile[]) => Promise<boolean>): Promise<boolean> {
    return this.guarded(async () => {
      const files = await this.fetched(() => given);
      return files !== null && files.length > 0 && work(files);
    });
  }

  /** Opens the files as keys of a motion. Call within `run`; fails if they have no keys. */
  open(files: readonly PickedFile[]): Promise<boolean> {
    return this.meet(pickedRequest(files));
  }

  /**
   * Adds the files' poses at this position, by default after the last key. Call within `run`; fails for another mesh.
   */
  addPoses(files: readonly PickedFile[], place?: InsertPosition | null): Promise<number | null> {
    return this.reading(() => addPoses(this.parts, files, place));
  }

  /** Restores earlier content; false if there is none. */
  again(left: StoredProject | Snapshot | null, step: Step | null = 'on'): Promise<boolean> {
    return this.guarded(async () => {
      if (!left) return false;
      // Cancels a sample that is still loading.
      this.fetching.abort();
      return this.meet(leftRequest(left, this.parts.samples(), step));
    });
  }

  /** Restores the content before this one; undoes opening. */
  back(): Promise<boolean> {
    return this.again(this.history.before, 'back');
  }

  /** Redoes opening. */
  forth(): Promise<boolean> {
    return this.again(this.history.after, 'forth');
  }

  /** Samples the keys again at these times of the animation's own timeline, in seconds. */
  resample(animation: number, times: number[]): Promise<boolean> {
    return this.guarded(() => this.meet(momentsRequest(this.present, animation, times)));
  }

  /** Takes the keys from the files' own animation, at the default times. */
  takeAnimation(): Promise<boolean> {
    return this.guarded(() => this.meet(animationRequest(this.present)));
  }

  /** Reads the files again with only these objects; an empty list means all. */
  takeObjects(objects: string[]): Promise<boolean> {
    return this.guarded(() => this.meet(objectsRequest(this.present, objects)));
  }

  /** Reads the files again with another up axis or unit. */
  reorient(orientation: Orientation, step: Step | null = 'on'): Promise<boolean> {
    return this.guarded(() => this.meet(turnRequest(this.present, orientation, step)));
  }

  /** Adds the files' poses after the last key. */
  async addKeys(files: Promise<PickedFile[]>): Promise<void> {
    await this.guarded(async () => (await this.addPoses(await files)) !== null);
  }

  /** Uses a file's shape for the tangent at an end of the motion. */
  async takeTangent(given: PickedFile[] | Promise<PickedFile[]>, end: End): Promise<void> {
    const { say } = this.parts;
    await this.guarded(async () => {
      const files = await given;
      const name = files.length > 0 ? await this.reading(() => takeTangent(this.parts, files, end)) : null;
      if (name) say(`“${name}” now sets the ${end} tangent.`);
      return name !== null;
    });
  }

  private get present(): Present {
    const { store, workspace } = this.parts;
    return { files: workspace.input, options: workspace.options, state: store.get() };
  }

  /** The common path of all requests. */
  private async meet(request: OpenRequest): Promise<boolean> {
    const { store, workspace, reducedMotion, say, onStart, onOpened, onRead } = this.parts;
    const { options, source, step, picked = false, left, stays = false, turn } = request;
    onStart();
    const opening = await workspace.open(request.input, options, {
      stays,
      otherwise: ({ warnings }) =>
        picked && warnings.some(({ code }) => code === 'z-up') ? { ...options, up: 'z' } : null,
      start: (read, pool) =>
        startOf(request, read, pool, turn ? currentSnapshot(store, workspace) : null, workspace.pool),
      leave: () => {
        if (step && !turn) this.history.left(currentSnapshot(store, workspace)!, step);
      },
    });
    if (!opening) return false;
    const state = openedState(request, opening, store.get(), workspace.range, reducedMotion());
    onOpened({
      ...opening,
      source,
      orientation: orientationOf(workspace.input, workspace.options),
      stoodUp: workspace.options !== options,
      objects: options.objects ?? [],
      camera: state.view.camera,
      picked,
      stays,
    });
    workspace.aheadOfState = false;
    if (turn) {
      store.set({ view: state.view });
      // Undo and redo bring the document themselves.
      if (step)
        store.turned(orientationStep(turn.before, turn.after), turn, (doc) =>
          reorientedDoc(doc, turn.before, turn.after),
        );
      onRead();
      return true;
    }
    store.reset(state, left && 'history' in left ? left.history : undefined);
    const unused = opening.link && ignoredValues(opening.link, opening.doc);
    const said = [...opening.lost, ...(unused ? [unused] : [])];
    if (said.length > 0) say(said.join(' '));
    return true;
  }

  /** Replaces the current fetch; null if a later fetch replaces this one. */
  private async fetched<T>(get: (signal: AbortSignal) => T | Promise<T>): Promise<T | null> {
    this.fetching.abort();
    this.fetching = new AbortController();
    const { signal } = this.fetching;
    try {
      const files = await get(signal);
      return signal.aborted ? null : files;
    } catch (error) {
      if (signal.aborted) return null;
      throw error;
    }
  }

  private async reading<T>(work: () => Promise<T>): Promise<T> {
    const { onStart, onWorking } = this.parts;
    onStart();
    onWorking({ stage: 'reading', fraction: 0 });
    try {
      return await work();
    } finally {
      onWorking(null);
    }
  }

  /** Reports errors to the user. */
  private guarded(work: () => Promise<boolean>): Promise<boolean> {
    this.asks += 1;
    const task = work().catch((error: unknown) => {
      this.parts.onError(error);
      return false;
    });
    this.running.add(task);
    return task.finally(() => this.running.delete(task));
  }
}
