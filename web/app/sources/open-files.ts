/** Ways in: a sample, a link, files of the user, another sampling of an animation, further keys from a file. */
import type { Engine } from '../../engine/api/api.ts';
import { isCancelled } from '../../engine/api/errors.ts';
import type { ImportOptions, InputFile, KeysInfo, Progress } from '../../engine/api/types.ts';
import { orientationStep, reoriented } from '../../model/orientation.ts';
import type { Orientation } from '../../model/orientation.ts';
import type { End } from '../../model/speeds.ts';
import type { Doc, Source, View } from '../../model/state.ts';
import { DEFAULT_VIEW, EMPTY_STATE } from '../../model/state.ts';
import type { PickedFile } from '../../ui/dropped-files.ts';
import type { PosePool } from '../session/pose-pool.ts';
import type { Store } from '../session/store.ts';
import type { Input, Workspace } from '../session/workspace.ts';
import { addPoses, takeTangent } from './add-poses.ts';
import { readFiles } from './input-files.ts';
import { Openings } from '../kept/openings.ts';
import {
  isBuried,
  ofFiles,
  ofSample,
  openingPlay,
  openingTime,
  openingView,
  orientationOf,
  restored,
  withSettings,
} from './opened-state.ts';
import { applyPermalink, leftOut } from './permalink.ts';
import type { Permalink } from './permalink.ts';
import { newProjectId } from '../kept/project-shelf.ts';
import type { Remembered } from '../kept/project-shelf.ts';
import type { Sample } from './samples.ts';
import { fetchSample } from './samples.ts';
import { currentWork } from '../kept/work.ts';
import type { Work } from '../kept/work.ts';

/** What is open now, while the state does not say so yet. */
export interface OpenedFiles {
  info: KeysInfo;
  pool: PosePool;
  source: Source;
  doc: Doc;
  /** The document that the files start with when nothing else is known: links are written against it. */
  initial: Doc;
  /** How the files were read where they do not say it themselves. */
  orientation: Orientation | null;
  /** They were stood up for how their shapes look. */
  stoodUp: boolean;
  /** The objects of the files that were taken; empty for all of them. */
  objects: readonly string[];
  /** Of a link or an earlier visit. */
  camera: View['camera'];
  /** The user has just picked them, and has chosen nothing about them yet. */
  picked: boolean;
  /** The same mesh as before, with other keys or lying otherwise. */
  stays: boolean;
}

export interface OpenFilesParts {
  engine: Engine;
  store: Store;
  workspace: Workspace;
  samples(): readonly Sample[];
  reducedMotion(): boolean;
  say(text: string): void;
  /** Something else is asked for: what went wrong before is of no interest. */
  onStart(): void;
  onOpened(opened: OpenedFiles): void;
  /** The files were read anew for the same document: what is shown is to be made of them. */
  onRead(): void;
  /** Of reading further poses; an import is told of by the workspace. */
  onWorking(working: Progress | null): void;
  onError(error: unknown): void;
}

export interface OpenFiles {
  /** Resolve to whether what was asked for is open now. `input`: the sample's files, where they are on their way. */
  sample(id: string, link?: Permalink | null, input?: Promise<InputFile[]> | null): Promise<boolean>;
  /** Opens what a link names, without a step that undo goes back over. */
  show(link: Permalink): Promise<boolean>;
  /** Does with the files what `work` says, unless other ones are asked for before they are there. */
  run(files: PickedFile[] | Promise<PickedFile[]>, work: (files: PickedFile[]) => Promise<boolean>): Promise<boolean>;
  /** Opens them as the keys of a motion. To be run; fails where they are not. */
  open(files: readonly PickedFile[]): Promise<boolean>;
  /** Adds their poses before the key `place`, by default after the last. To be run; fails on another mesh. */
  addPoses(files: readonly PickedFile[], place?: number | null): Promise<number | null>;
  /** Opens what an earlier visit left, or this one; quietly: without a step that undo goes back over. */
  again(left: Remembered | Work, how?: { quietly: boolean }): Promise<boolean>;
  /** What was open before this, as it was left; opening is undone by it. */
  back(): Promise<boolean>;
  /** Redoes that. */
  forth(): Promise<boolean>;
  readonly openings: Readonly<Pick<Openings, 'before' | 'after' | 'all' | 'left' | 'forget'>>;
  /** Takes the keys anew, at these seconds of the animation's own timeline. */
  resample(animation: number, times: number[]): Promise<boolean>;
  /** Takes the keys from the animation that the files hold themselves, at the times that are taken by default. */
  takeAnimation(): Promise<boolean>;
  /** Reads the files again with these of their objects; with none, all of them. */
  takeObjects(objects: string[]): Promise<boolean>;
  /** Reads the files again with another axis up or another unit; quietly: without a step that undo goes back over. */
  reorient(orientation: Orientation, how?: { quietly: boolean }): Promise<boolean>;
  /** Adds the files' poses after the last key. */
  addKeys(files: PickedFile[]): Promise<void>;
  /** The shape of a file gives the tangent at an end of the motion. */
  takeTangent(files: PickedFile[] | Promise<PickedFile[]>, end: End): Promise<void>;
  readonly busy: boolean;
  /** How often anything was asked for so far. */
  readonly asks: number;
  /** Resolves when nothing is being opened. */
  idle(): Promise<void>;
}

interface Request {
  input: Input;
  options: ImportOptions;
  source: Source;
  /** Of files of the user. */
  project: string | null;
  adjust(doc: Doc, pool: PosePool): Doc;
  link: Permalink | null;
  /** By the user just now: shapes that seem to lie are stood up. */
  picked?: boolean;
  /** How it was left before. */
  left?: Remembered | Work;
  /** The document is the one that is open, its time and history go on. */
  onTurned?: () => void;
  /** The same mesh: time, view and playing go on. */
  stays?: boolean;
  /** What is left for it, and how that is found again; by default, by undoing. */
  onLeft?: ((work: Work) => void) | undefined;
}

const forgotten = (): void => undefined;

export function createOpenFiles({
  engine,
  store,
  workspace,
  samples,
  reducedMotion,
  say,
  onStart,
  onOpened,
  onRead,
  onWorking,
  onError,
}: OpenFilesParts): OpenFiles {
  let fetching = new AbortController();
  const running = new Set<Promise<unknown>>();
  let asks = 0;

  const openings = new Openings();

  const open = async (request: Request): Promise<boolean> => {
    const { input, options, source, project, adjust, link, left, onLeft = (work) => openings.left(work) } = request;
    onStart();
    let initial = EMPTY_STATE.doc;
    let leaving: Work | null = null;
    let stoodUp = false;
    let buried = false;
    const opened = await workspace.open(input, options, {
      otherwise({ warnings }) {
        stoodUp = request.picked === true && warnings.some(({ code }) => code === 'z-up');
        return stoodUp ? { ...options, up: 'z' } : null;
      },
      adjust(doc, pool) {
        initial = adjust(doc, pool);
        if (left) return restored(left, pool);
        if (!link) return initial;
        const { report, faces } = pool.keys.info;
        const linked = applyPermalink(initial, link, report.components);
        buried = isBuried(link.view.camera ?? null, link.time ?? linked.keys[0]?.time ?? 0, linked, pool, faces);
        return linked;
      },
      camera: request.stays ? null : () => (buried ? null : ((left?.state.view ?? link?.view)?.camera ?? null)),
      leave: () => (leaving = currentWork(store, workspace)),
    });
    if (!opened) return false;
    const { info, doc } = opened;
    if (leaving && !request.onTurned) onLeft(leaving);
    const before = store.get();
    const wanted = left
      ? { ...DEFAULT_VIEW, ...left.state.view }
      : request.onTurned
        ? { ...before.view, camera: null }
        : request.stays
          ? before.view
          : openingView(before.view, link);
    const pool = workspace.pool!;
    const firstTime = request.stays ? before.time : (link?.time ?? null);
    const time = left?.state.time ?? openingTime(doc, workspace.range, firstTime);
    const view = buried ? { ...wanted, camera: null } : wanted;
    onOpened({
      info,
      pool,
      source,
      doc,
      initial,
      orientation: orientationOf(workspace.input, workspace.options),
      stoodUp,
      objects: options.objects ?? [],
      camera: view.camera,
      picked: request.picked === true,
      stays: request.stays === true,
    });
    if (request.onTurned) {
      store.set({ view });
      request.onTurned();
      onRead();
      return true;
    }
    const play = left
      ? { ...left.state.play, playing: false }
      : request.stays
        ? before.play
        : openingPlay(opened, source, link, before.play, reducedMotion());
    store.reset({ source, project, doc, view, play, time }, left && 'history' in left ? left.history : undefined);
    const unused = link && leftOut(buried ? { ...link, unfit: [...link.unfit, 'camera'] } : link, doc);
    if (unused) say(unused);
    return true;
  };

  const guarded = (work: () => Promise<boolean>): Promise<boolean> => {
    asks += 1;
    const task = work().catch((error: unknown) => {
      onError(error);
      return false;
    });
    running.add(task);
    return task.finally(() => running.delete(task));
  };

  const poses = { engine, store, workspace };
  const reading = async <T>(work: () => Promise<T>): Promise<T> => {
    onStart();
    onWorking({ stage: 'reading', fraction: 0 });
    try {
      return await work();
    } finally {
      onWorking(null);
    }
  };

  /** The files once more, lying as they were said to lie; what keys there are is asked anew. */
  const reread = (change: ImportOptions, first?: typeof ofFiles): Promise<boolean> => {
    const { up, unit, objects } = workspace.options;
    const options = { up, unit, objects, ...change };
    const { source, project, doc } = store.get();
    const adjust = (fresh: Doc, pool: PosePool): Doc => {
      const same = withSettings(fresh, doc);
      return first ? first(same, pool.keys.info) : same;
    };
    return open({
      input: workspace.input,
      options,
      source,
      project,
      adjust,
      link: null,
      stays: !('objects' in change),
    });
  };

  const again = (left: Remembered | Work, onLeft?: (work: Work) => void): Promise<boolean> => {
    // A sample that is on its way is not wanted any more.
    fetching.abort();
    const { source, project } = left.state;
    const sample = source.kind === 'sample' && samples().find(({ id }) => id === source.id);
    return open({
      input: left.files,
      options: left.options,
      source,
      project: source.kind === 'files' ? (project ?? newProjectId()) : null,
      adjust: (doc, pool) => (sample ? ofSample(doc, sample) : ofFiles(doc, pool.keys.info)),
      link: null,
      left,
      onLeft,
    });
  };

  const stepTo = async (work: Work | null, onLeft: (work: Work) => void): Promise<boolean> =>
    work !== null && (await again(work, onLeft));

  const openSample = (
    id: string,
    link: Permalink | null,
    given: Promise<InputFile[]> | null,
    onLeft?: (work: Work) => void,
  ): Promise<boolean> =>
    guarded(async () => {
      const sample = samples().find((one) => one.id === id);
      if (!sample) throw new Error(`There is no sample named “${id}”. Choose one from the list.`);
      fetching.abort();
      fetching = new AbortController();
      const { signal } = fetching;
      const input = await (given ?? fetchSample(sample, signal)).catch((error: unknown) => {
        if (signal.aborted) return null;
        throw error;
      });
      if (!input || signal.aborted) return false;
      const options = sample.times ? { keyTimes: sample.times } : {};
      const request = {
        input,
        options,
        source: { kind: 'sample', id },
        project: null,
        adjust: (doc: Doc) => ofSample(doc, sample),
        onLeft,
      } as const;
      return open({ ...request, link }).catch(async (error: unknown) => {
        // What the engine refuses of a link must not keep the sample closed.
        const final = isCancelled(error) || (error as { code?: unknown }).code === 'not-loaded';
        if (!link || final || !(await open({ ...request, link: null }))) throw error;
        onError(error);
        return true;
      });
    });

  const reorient = (orientation: Orientation, quietly: boolean): Promise<boolean> => {
    const { source, project, doc } = store.get();
    const { options, pool: present, input } = workspace;
    const before = orientationOf(input, options) ?? orientation;
    return open({
      input,
      options: { ...options, ...orientation },
      source,
      project,
      adjust(fresh, pool) {
        if (!present) return fresh;
        // Poses that are not of the files lie as they do.
        const offsets = [present.keys.info.offset, pool.keys.info.offset] as const;
        for (let pose = present.imported + pool.count - pool.imported; pose < present.count; pose += 1) {
          const positions = reoriented(present.keys.positions(pose), before, orientation, offsets);
          pool.add(present.keys.info.names[pose] ?? '', positions);
        }
        return doc;
      },
      link: null,
      stays: true,
      onTurned() {
        if (!quietly) store.turned(orientationStep(before, orientation), { before, after: orientation });
      },
    });
  };

  const openFiles = (files: readonly PickedFile[]): Promise<boolean> =>
    open({
      input: (report, signal) => readFiles(files, report, signal),
      options: {},
      source: { kind: 'files', names: files.map(({ name }) => name) },
      project: newProjectId(),
      adjust: (doc, pool) => ofFiles(doc, pool.keys.info),
      link: null,
      picked: true,
    });

  const opener: OpenFiles = {
    sample: (id, link = null, input = null) => openSample(id, link, input),
    show: (link) => openSample(link.sample, link, null, forgotten),
    run: (given, work) =>
      guarded(async () => {
        fetching.abort();
        fetching = new AbortController();
        const { signal } = fetching;
        const files = await given;
        return !signal.aborted && files.length > 0 && work(files);
      }),
    open: openFiles,
    addPoses: (files, place) => reading(() => addPoses(poses, files, place)),
    again: (left, how) => guarded(() => again(left, how?.quietly ? forgotten : undefined)),
    back: () => guarded(async () => stepTo(openings.before, (work) => openings.steppedBack(work))),
    forth: () => guarded(async () => stepTo(openings.after, (work) => openings.steppedForth(work))),
    openings,
    resample: (animation, times) => guarded(() => reread({ animation, sample: times })),
    takeAnimation: () => guarded(() => reread({ animation: 0 }, ofFiles)),
    takeObjects: (objects) => {
      const { animation, sample } = workspace.options;
      return guarded(() => reread({ animation, sample, objects: objects.length > 0 ? objects : undefined }));
    },
    reorient: (orientation, how) => guarded(() => reorient(orientation, how?.quietly === true)),
    addKeys: async (files) => {
      await guarded(async () => (await opener.addPoses(files)) !== null);
    },
    takeTangent: async (files, end) => {
      await guarded(async () => {
        const given = await files;
        const name = given.length > 0 ? await reading(() => takeTangent(poses, given, end)) : null;
        if (name) say(end === 'start' ? `The motion leaves towards “${name}”.` : `The motion arrives from “${name}”.`);
        return name !== null;
      });
    },
    get busy() {
      return running.size > 0;
    },
    get asks() {
      return asks;
    },
    idle: async () => {
      while (running.size > 0) await Promise.all(running);
    },
  };
  return opener;
}
