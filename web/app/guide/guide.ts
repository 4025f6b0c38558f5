/**
 * The guide: pages that are states of the app, each with a link. Closing it restores the earlier content, unless the
 * user has opened something else.
 */
import '../../ui/styles/guide.css';
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
import { filled, pressed, untilTouched, waitForElement } from './wait-for-element.ts';

export interface GuideParts extends ReturnPointParts {
  /** Places the guide's panel, beside wider panels if requested; null removes it. */
  place(panel: HTMLElement | null, wide?: boolean): void;
  /** Scrolls to a panel or a part of it. */
  showPanel(name: PanelName, part?: string): void;
  /** Shows another page of this site instead of the panels, if there is room; null restores the panels. */
  frame(page: { href: string; title: string } | null): void;
  /** Call before closing the open content; stores its pending changes. */
  keep(): void;
  /** Fixes this fragment in the URL; null lets the URL follow the state again. */
  pin(fragment: string | null): void;
}

export interface Guide {
  /** Goes to a link's page; false if the link names no page. */
  open(fragment: string): Promise<boolean>;
  /** Restores the earlier content. */
  close(): Promise<void>;
  /** Content was opened. Ends the guide unless the content is one of its pages. */
  onOpened(): void;
  /** The numbers of the shown motion have changed. */
  setFacts(facts: Facts | null): void;
  readonly isOpen: boolean;
  /** Plot of the current page, or null. */
  readonly plot: Plot | null;
  /** Leaves the guide if a page is being opened. Returns true if the guide was opening a page or closing. */
  cancel(): boolean;
}

const nothing = (): void => undefined;

/** The keys of presenters' clickers. */
const CLICKS: Readonly<Record<string, 'previous' | 'next'>> = { PageUp: 'previous', PageDown: 'next' };

export function createGuide(parts: GuideParts): Guide {
  const { store, workspace, files, place, keep, pin } = parts;
  let page: GuidePage | null = null;
  /** Counts the pages that are being opened. */
  let turning = 0;
  /** Undoes the preparations of the current page. */
  let takeBack = nothing;
  const back = createReturnPoint(parts);
  const panel = createGuidePanel(() => void guide.close());
  const answers = createAnswers(workspace, (answer) => panel.setLive(answer));
  /** A presentation continues with the next page. */
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

/** Applies a page's additions to its state; the result undoes them. */
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
  if (press) undone.push(waitForElement(press, (control) => undone.push(pressed(control))));
  if (fill) undone.push(waitForElement(fill.field, (field) => undone.push(filled(field, fill.value))));
  return () => undone.forEach((one) => one());
}

/** Requests the page's numbers of the motion once. */
function createAnswers(workspace: Workspace, onAnswer: (answer: string) => void) {
  /** The last answer and its motion. */
  let asked: { of: Facts['stats']; answer: string } | null = null;
  return {
    async ask(page: GuidePage, facts: Facts): Promise<void> {
      const { stats } = facts;
      const sequence = workspace.sequences[0]?.sequence;
      const poses = workspace.pool?.keys;
      if (!sequence || !poses || !page.ask || asked?.of === stats) return;
      const question = { of: stats, answer: '' };
      asked = question;
      const answer = await page.ask(sequence, facts, poses).catch(() => ''); // The motion has changed meanwhile.
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

/** Titles of the kinds of pages. */
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
