/**
 * The guide: pages that are states of the app, named by links. Leaving it restores the content that was open before,
 * unless the user opened other content in the meantime.
 */
import type { Plot } from '../../model/state.ts';
import { createGuidePanel } from '../../ui/guide-panel.ts';
import type { GuidePanelProps } from '../../ui/guide-panel.ts';
import type { PanelName } from '../panels/layout.ts';
import type { Workspace } from '../session/workspace.ts';
import { readPermalink } from '../sources/permalink.ts';
import { FIGURES } from './figures.ts';
import type { Facts, GuidePage } from './guide-page.ts';
import { TOUR } from './tour.ts';
import { createReturnPoint } from './return-point.ts';
import type { ReturnPointParts } from './return-point.ts';
import { filled, pressed, untilTouched, whenThere } from './when-there.ts';

export interface GuideParts extends ReturnPointParts {
  /** Where its panel stands, beside wider options where it wants them; null takes it away. */
  place(panel: HTMLElement | null, wide?: boolean): void;
  /** Brings options or plots in sight. */
  showPanel(name: PanelName, part?: string): void;
  /** Shows another page of this site in the place of the options, where there is room; null: the options. */
  frame(page: { href: string; title: string } | null): void;
  /** What is open is about to be closed: what of it waits to be kept is kept now. */
  keep(): void;
  /** The address keeps this fragment; null: it follows the state. */
  pin(fragment: string | null): void;
}

export interface Guide {
  /** Turns to the page of a link; false where there is none. */
  open(fragment: string): Promise<boolean>;
  /** Gives back what was open before. */
  close(): Promise<void>;
  /** Something was opened: where it is not of the guide, the guide is over. */
  onOpened(): void;
  /** What is shown has changed. */
  setFacts(facts: Facts | null): void;
  readonly isOpen: boolean;
  /** The plot that the page on show speaks of, or null. */
  readonly plot: Plot | null;
  /** Leaves the guide if one of its pages is being opened; true if that, or the way back, is under way. */
  cancel(): boolean;
}

const nothing = (): void => undefined;

/** What presenters' clickers send. */
const CLICKS: Readonly<Record<string, 'previous' | 'next'>> = { PageUp: 'previous', PageDown: 'next' };

export function createGuide(parts: GuideParts): Guide {
  const { store, workspace, files, place, keep, pin } = parts;
  let page: GuidePage | null = null;
  /** It is opening a page of its own. */
  let turning = 0;
  /** Of what the page on show has prepared. */
  let takeBack = nothing;
  const back = createReturnPoint(parts);
  const panel = createGuidePanel(() => void guide.close());
  const answers = createAnswers(workspace, (answer) => panel.setLive(answer));
  /** A presentation goes on with the next page. */
  const presenting = (): boolean => store.get().view.present !== null;
  listenToClicker(
    () => page !== null && presenting(),
    (turn) => panel.turn(turn),
  );

  const leave = (): void => {
    takeBack();
    takeBack = nothing;
    page = null;
    place(null);
    pin(null);
  };

  const guide: Guide = {
    async open(fragment) {
      const wanted = [...TOUR, ...FIGURES].find(({ link }) => link === fragment);
      const state = wanted && readPermalink(wanted.state);
      if (!wanted || !state) return false;
      if (!page) {
        keep();
        back.remember();
      }
      const enters = page === null && document.activeElement !== document.body;
      page = wanted;
      pin(wanted.link);
      panel.show(shown(wanted));
      place(panel.element, wanted.wide);
      if (enters) panel.focus();
      takeBack();
      takeBack = nothing;
      answers.forget();
      turning += 1;
      const present = presenting() ? 'shape' : null;
      await files.show({ ...state, view: { ...state.view, present } }).finally(() => (turning -= 1));
      if (page === wanted) takeBack = prepare(wanted, parts);
      return true;
    },
    async close() {
      if (!page) return;
      leave();
      await back.go();
    },
    onOpened() {
      if (!page || turning > 0) return;
      back.drop();
      leave();
    },
    setFacts(facts) {
      if (!page) return;
      const open = facts && turning === 0 ? facts : null;
      if (open) void answers.ask(page, open);
      panel.setLive((open && page.live?.(open)) ?? (page.ask && answers.last) ?? '');
    },
    get isOpen() {
      return page !== null;
    },
    get plot() {
      return page?.plot ?? null;
    },
    cancel() {
      const turns = page !== null && turning > 0;
      if (turns) void guide.close();
      return turns || back.underWay;
    },
  };
  return guide;
}

/** Shows what a page needs in addition to its state; the result undoes that. */
function prepare(
  { panel, part, press, fill, beside }: GuidePage,
  { frame, showPanel }: Pick<GuideParts, 'frame' | 'showPanel'>,
): () => void {
  const undone: (() => void)[] = [];
  if (beside) {
    frame({ href: beside.href, title: beside.framed });
    undone.push(() => frame(null));
  }
  if (panel) undone.push(untilTouched(panel, () => showPanel(panel, part)));
  if (press) undone.push(whenThere(press, (control) => undone.push(pressed(control))));
  if (fill) undone.push(whenThere(fill.field, (field) => undone.push(filled(field, fill.value))));
  return () => undone.forEach((one) => one());
}

/** Asks the engine what a page wants to know of the motion, once. */
function createAnswers(workspace: Workspace, onAnswer: (answer: string) => void) {
  /** What was asked last, and of which motion. */
  let asked: { of: Facts['stats']; answer: string } | null = null;
  return {
    async ask(page: GuidePage, facts: Facts): Promise<void> {
      const { stats } = facts;
      const sequence = workspace.sequences[0]?.sequence;
      const poses = workspace.pool?.keys;
      if (!sequence || !poses || !page.ask || asked?.of === stats) return;
      const question = { of: stats, answer: '' };
      asked = question;
      const answer = await page.ask(sequence, facts, poses).catch(() => ''); // another motion came between
      if (asked !== question) return;
      question.answer = answer;
      onAnswer(answer);
    },
    forget(): void {
      asked = null;
    },
    get last(): string | undefined {
      return asked?.answer;
    },
  };
}

function listenToClicker(listens: () => boolean, onTurn: (turn: 'previous' | 'next') => void): void {
  window.addEventListener(
    'keydown',
    (event) => {
      const turn = CLICKS[event.key];
      if (!turn || !listens()) return;
      event.preventDefault();
      onTurn(turn);
    },
    { capture: true },
  );
}

/** What the pages of a kind are called together. */
const KINDS = [
  { name: 'Tour', pages: TOUR },
  { name: 'Figures', pages: FIGURES },
] as const;

function shown(page: GuidePage): GuidePanelProps {
  const { name, pages } = KINDS.find((kind) => kind.pages.includes(page))!;
  const current = pages.indexOf(page);
  const { title, text, task, sentence, formula = null, more = null, beside = null } = page;
  return {
    ...{ title, text, task, sentence, formula, more, beside, current },
    place: `${name}, ${current + 1} of ${pages.length}`,
    pages: pages.map((one) => ({ label: one.link.split('=')[1]!, title: one.title, link: one.link })),
  };
}
