/**
 * Keys from an animation: which animation, their number or an error bound, and their times. Choices take effect
 * immediately.
 */
import { OWN_METHOD } from '../engine/api/methods.ts';
import { SAMPLED_KEYS } from '../engine/api/option-table.ts';
import type { AnimationInfo, KeysInfo } from '../engine/api/types.ts';
import type { Span } from '../model/sample-times.ts';
import { areSampled, evenTimes, readTimes, sameTimes, shortTime } from '../model/sample-times.ts';
import { fitKey, isTimed, type TimingResult } from '../model/fitted-timing.ts';
import type { Doc } from '../model/state.ts';
import { button, checkbox, select } from './controls.ts';
import type { Component, Fields } from './dom.ts';
import { h, memo, say, setField, setHidden, setText } from './dom.ts';
import { createSampleTrack } from './sample-track.ts';
import { createSamplingMode } from './sampling-mode.ts';

/** A mark moved by an arrow key is likely to move again soon. */
const TAKE_DELAY_MS = 300;

const NO_ANIMATION: AnimationInfo = { name: '', start: 0, end: 1, keys: 0, moves: false };

export interface SamplingProps {
  /** Information on the keys; null without an animation. */
  info: KeysInfo | null;
  /** Number of keys found for an error in percent; null without a search. */
  fewest: { keys: number; percent: number } | null;
  /** The animation is shown beside the motion. */
  original: boolean;
  /** Result of the last fit of the timing. */
  timing: TimingResult | null;
  doc: Doc;
}

export interface SamplingEvents {
  onTake(animation: number, times: number[]): void;
  /**
   * Chooses the fewest keys within this percentage of the diagonal; resolves when they are in use or the search has
   * ended without them.
   */
  onFewest(animation: number, percent: number): Promise<void>;
  onOriginal(shown: boolean): void;
  /** Fits the timing to this animation; resolves at its end. */
  onFit(animation: number): Promise<void>;
  /** Removes all timing. */
  onPlain(): void;
}

export type Sampling = Component<SamplingProps>;

export function createSampling({ onTake, onFewest, onOriginal, onFit, onPlain }: SamplingEvents): Sampling {
  let animations: readonly AnimationInfo[] = [];
  let chosen = 0;
  let times: number[] = [];
  /** The keys are from the animation, rather than compared with it. */
  let taken = false;
  const soon = later(() => onTake(chosen, times), TAKE_DELAY_MS);
  const span = (): AnimationInfo => animations[chosen] ?? NO_ANIMATION;
  const choose = (next: readonly number[]): void => {
    times = [...new Set(next)].sort((a, b) => a - b);
    track.update(span(), times);
    list.update(times);
    mode.setCount(times.length, taken);
  };
  const takeSoon = (next: readonly number[]): void => {
    taken = true;
    mode.update(taken, false);
    choose(next);
    soon.start();
  };

  const animation = select<string>('Animation', 'animation', [], (value) => {
    chosen = Number(value);
    takeSoon(evenTimes(span(), times.length));
  });
  const mode = createSamplingMode({
    onCount: (count) => takeSoon(evenTimes(span(), count)),
    onFewest(percent) {
      soon.stop();
      return onFewest(chosen, percent);
    },
  });
  const found = h('p', { class: 'hint', role: 'status', 'data-testid': 'sample-found', hidden: true });
  const original = checkbox('Show the animation beside the motion', 'sample-original', onOriginal);
  const timing = createTimingFit(() => onFit(chosen), onPlain);
  const track = createSampleTrack(choose, takeSoon);
  const list = createTimesList(span, takeSoon);
  const title = h('strong', {}, '');
  const element = h(
    'section',
    { class: 'group animation-source', hidden: true, 'data-testid': 'sampling', 'aria-label': 'Animation' },
    title,
    animation.element,
    ...mode.elements,
    found,
    original.element,
    ...timing.elements,
    h(
      'details',
      { class: 'details' },
      h('summary', { 'data-testid': 'sample-times-open' }, 'Times of the keys'),
      track.element,
      ...list.elements,
    ),
  );

  const read = memo(({ info }: { info: KeysInfo | null }) => {
    animations = info?.animations ?? [];
    const firstMoving = animations.findIndex(({ moves }) => moves);
    setHidden(element, firstMoving < 0);
    // A choice made meanwhile is applied next.
    if (!info || firstMoving < 0 || soon.waits()) return;
    chosen = info.animation < 0 ? firstMoving : info.animation;
    animation.update(String(chosen), animations.map(choiceOf));
    const count = animations.filter(({ together = [] }) => together.length === 0).length;
    setText(title, `The files have ${count > 1 ? `${count} animations` : 'an animation'}`);
    const before = taken;
    taken = areSampled(info);
    const next = taken ? info.times : evenTimes(span(), SAMPLED_KEYS);
    // The times in use are already shown, with the state of the next choice.
    if (taken !== before || !sameTimes(next, times)) choose(next);
    else track.update(span(), times);
  });
  return {
    element,
    update({ info, fewest, original: shown, timing: fitted, doc }) {
      read({ info });
      mode.update(taken, fewest !== null && !soon.waits());
      say(found, fewest ? foundText(fewest) : coarseText(span(), taken ? times.length : Infinity));
      original.update(shown);
      timing.update({ timing: fitted, doc, canFit: taken && doc.motion.method === OWN_METHOD });
    },
  };
}

/** Fits the timing between the keys to the animation. */
function createTimingFit(onFit: () => Promise<void>, onPlain: () => void) {
  const hint = 'Lets the parts of the shape move between the keys when they do in the animation';
  const fit = button({
    label: hint,
    text: 'Fit timing',
    testId: 'fit-timing',
    onClick: () => {
      fit.disabled = true;
      void onFit().finally(() => (fit.disabled = false));
    },
  });
  const plain = button({ label: 'Remove all timing', text: 'Remove', testId: 'plain-timing', onClick: onPlain });
  const row = h('div', { class: 'button-row' }, fit, plain);
  const said = h('p', { class: 'hint', role: 'status', 'data-testid': 'fit-timing-result', hidden: true });
  return {
    elements: [row, said],
    update({ timing, doc, canFit }: Pick<SamplingProps, 'timing' | 'doc'> & { canFit: boolean }): void {
      const timed = isTimed(doc);
      setHidden(row, !canFit && !timed);
      setHidden(fit, !canFit);
      setHidden(plain, !timed);
      const stale = timing !== null && timed && timing.key !== fitKey(doc);
      setText(fit, stale ? 'Fit again' : 'Fit timing');
      say(said, !timing ? '' : stale ? STALE : fittedText(timing, timed));
    },
  };
}

const STALE = 'Keys, times or options have changed since the timing was fitted.';

function fittedText({ unseen }: TimingResult, timed: boolean): string {
  if (!unseen) return timed ? 'Timing fitted to every frame between the keys.' : '';
  const [before, after] = [unseen.before, unseen.after].map((error) => `${Number(error.toPrecision(3))} %`);
  const where = `on ${unseen.frames} frames that a fit to the others has not seen`;
  if (timed) return `Timing fitted. Error ${before} before, ${after} after, ${where}.`;
  return unseen.after < unseen.before ? '' : `Not used: the error would rise from ${before} to ${after} ${where}.`;
}

/** Runs after a delay since the last start. */
function later(run: () => void, ms: number): { start(): void; stop(): void; waits(): boolean } {
  let timer = 0;
  const stop = (): void => {
    window.clearTimeout(timer);
    timer = 0;
  };
  return {
    start() {
      stop();
      timer = window.setTimeout(() => {
        timer = 0;
        run();
      }, ms);
    },
    stop,
    waits: () => timer !== 0,
  };
}

/** The times as editable text. */
function createTimesList(span: () => Span, onTake: (times: number[]) => void): Fields<readonly number[]> {
  const list = h('input', {
    type: 'text',
    'data-testid': 'sample-times',
    'aria-label': 'Times of the keys in seconds',
    title: 'Times of the keys in seconds',
    spellcheck: false,
    autocomplete: 'off',
    onchange() {
      const read = readTimes(list.value, span());
      if (typeof read === 'string') say(reason, read);
      else onTake(read);
    },
    onkeydown(event: KeyboardEvent) {
      if (event.key === 'Enter') list.blur();
    },
  });
  const reason = h('p', { class: 'reason', 'data-testid': 'sample-reason', hidden: true });
  return {
    elements: [list, reason],
    update(times) {
      say(reason, '');
      setField(list, times.map(shortTime).join(', '));
    },
  };
}

/** A single pose is listed, but keys cannot be sampled from it. */
function choiceOf({ name, start, end, keys, moves, together = [] }: AnimationInfo, index: number) {
  const count = keys === 1 ? '1 key' : `${keys.toLocaleString('en')} keys`;
  const what = moves ? `${(end - start).toFixed(2)} s, ${count}` : `one pose, ${count}`;
  const label = `${together.length > 0 ? 'Together: ' : ''}${name || `Animation ${index + 1}`}  (${what})`;
  return { value: String(index), label, disabled: !moves };
}

function foundText({ keys, percent }: { keys: number; percent: number }): string {
  return `${keys} keys: the error is at most ${Number(percent.toPrecision(2))} % of the model’s size.`;
}

/** Warns that widely spaced keys do not reproduce the animation. */
function coarseText({ keys }: AnimationInfo, taken: number): string {
  return taken < keys ? `The original animation has ${keys.toLocaleString('en')} keys.` : '';
}
