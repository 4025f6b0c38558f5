/** The open content with its engine. Every edit updates the sequences or is undone. */
import type { Engine, Motion } from '../../engine/api/api.ts';
import type { Progress } from '../../engine/api/types.ts';
import { EMPTY_STATE } from '../../model/state.ts';
import type { Range } from '../../model/time-scale.ts';
import { motionRange } from './motion-range.ts';
import { sequencePlan } from './sequence-plan.ts';
import type { SequencePlan } from './sequence-plan.ts';
import { AppliedDocument } from './applied-document.ts';
import { createStore } from './store.ts';
import type { Store } from './store.ts';
import { WorkerRestart } from './worker-restart.ts';
import { Workspace } from './workspace.ts';
import type { WorkspaceEvents } from './workspace.ts';

export interface SessionEvents extends Pick<WorkspaceEvents, 'onRead' | 'onLarge' | 'onKeys' | 'onGivenUp'> {
  onWorking(working: Progress | null): void;
  /** The sequences match the document now. */
  onApplied(): void;
  /** The engine refused an edit, which is undone. */
  onError(error: unknown): void;
  /** A worker has ended. Requesting a frame starts a new one. */
  onRestart(): void;
}

/** An engine that started before its listeners existed. */
export interface StartedEngine {
  engine: Engine;
  /** A worker has ended unexpectedly. */
  onLost(): void;
}

export interface Session {
  engine: Engine;
  store: Store;
  workspace: Workspace;
  restart: WorkerRestart;
  listen(events: SessionEvents): void;
  /** The first running sequence. */
  sequence(): Motion | undefined;
  range(): Range;
  /** Updates the sequences if the document has changed. */
  serve(): void;
  /** Cancels the work in progress and undoes its edit. */
  cancel(): void;
}

/** Nothing listens yet. */
const QUIET: SessionEvents = {
  onRead: () => undefined,
  onLarge: () => undefined,
  onKeys: () => undefined,
  onGivenUp: () => undefined,
  onWorking: () => undefined,
  onApplied: () => undefined,
  onError: () => undefined,
  onRestart: () => undefined,
};

export function createSession(started: StartedEngine): Session {
  let events = QUIET;
  const store = createStore(EMPTY_STATE);
  const restart = new WorkerRestart(() => events.onRestart());
  const { engine } = started;
  started.onLost = () => void restart.tryAgain();
  const applied = new AppliedDocument(store);
  /** The state and history of each requested plan. Edits may follow before its motions are made. */
  const asked = new WeakMap<SequencePlan, Parameters<typeof applied.note>>();
  const workspace = new Workspace(engine, {
    onRead: (info) => events.onRead(info),
    onLarge: () => events.onLarge(),
    onKeys: (opening) => events.onKeys(opening),
    onGivenUp: () => events.onGivenUp(),
    onProgress: (working) => events.onWorking(working),
    onReady(plan) {
      const [state, history] = asked.get(plan) ?? [store.get(), store.history()];
      applied.note(state, history);
      events.onApplied();
    },
    onRefused(error) {
      events.onError(error);
      applied.goBack();
    },
  });
  return {
    engine,
    store,
    workspace,
    restart,
    listen(given) {
      events = given;
    },
    sequence: () => workspace.sequences[0]?.sequence,
    range: () => motionRange(store.get().doc, workspace.range),
    serve() {
      const { doc, view } = store.get();
      const plan = sequencePlan(doc, view);
      asked.set(plan, [store.get(), store.history()]);
      workspace.want(plan);
    },
    cancel() {
      workspace.cancel();
      applied.goBack();
    },
  };
}
