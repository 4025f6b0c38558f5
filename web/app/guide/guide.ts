/**
 * The guide: pages that are states of the app, told of by their links. What was open before comes back when it is left,
 * unless the reader has opened something else meanwhile.
 */
import { DEFAULT_VIEW } from '../../model/state.ts';
import type { Plot } from '../../model/state.ts';
import { createGuidePanel } from '../../ui/guide-panel.ts';
import type { GuidePanelProps } from '../../ui/guide-panel.ts';
import type { Work } from '../kept/work.ts';
import { currentWork } from '../kept/work.ts';
import type { PanelName } from '../panels/layout.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import type { Opener } from '../sources/opener.ts';
import { readPermalink } from '../sources/permalink.ts';
import { FIGURES } from './figures.ts';
import type { Facts, GuidePage } from './guide-page.ts';
import { TOUR } from './tour.ts';
import { filled, pressed, untilTouched, whenThere } from './when-there.ts';

export interface GuideParts {
  store: Store;
  workspace: Workspace;
  files: Opener;
  /** Where its panel stands, beside wider options where it wants them; null takes it away. */
  place(panel: HTMLElement | null, wide?: boolean): void;
  /** Brings options or plots in sight. */
  showPanel(name: PanelName, part?: string): void;
  /** Shows another page of this site in the place of the options, where there is room; null: the options. */
  frame(page: { href: string; title: string } | null): void;
  /** What is open is about to be closed: what of it waits to be kept is kept now. */
  keep(): void;
  /** Opens what a visit starts with. */
  openFirst(): Promise<void>;
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
  /** Leaves it where a page of it is being opened; true where that is what is under way, or the way back is. */
  cancel(): boolean;
}

const nothing = (): void => undefined;

/** What presenters' clickers send. */
const CLICKS: Readonly<Record<string, 'previous' | 'next'>> = { PageUp: 'previous', PageDown: 'next' };

export function createGuide({
  store,
  workspace,
  files,
  openFirst,
  place,
  showPanel,
  frame,
  keep,
  pin,
}: GuideParts): Guide {
  let page: GuidePage | null = null;
  /** It is opening a page of its own. */
  let turning = 0;
  /** It is opening what was there before, which is this. */
  let returning = 0;
  let comingBack: Work | null = null;
  /** What had the focus before the first page. */
  let focused: Element | null = null;
  /** What was open before the first page. */
  let before: Work | null = null;
  const panel = createGuidePanel(() => void guide.close());

  /** Of what the page on show has prepared. */
  let takeBack = nothing;
  const prepare = ({ panel: name, part, press, fill, beside }: GuidePage): void => {
    const undone: (() => void)[] = [];
    if (beside) {
      frame({ href: beside.href, title: beside.framed });
      undone.push(() => frame(null));
    }
    if (name) undone.push(untilTouched(name, () => showPanel(name, part)));
    if (press) undone.push(whenThere(press, (control) => undone.push(pressed(control))));
    if (fill) undone.push(whenThere(fill.field, (field) => undone.push(filled(field, fill.value))));
    takeBack = () => undone.forEach((one) => one());
  };

  const leave = (): void => {
    takeBack();
    takeBack = nothing;
    page = null;
    before = null;
    place(null);
    pin(null);
  };

  /** What the engine was asked for last, and of which motion. */
  let asked: { of: Facts['stats']; answer: string } | null = null;
  const ask = async (wanted: GuidePage, facts: Facts): Promise<void> => {
    const { stats } = facts;
    const sequence = workspace.sequences[0]?.sequence;
    if (!sequence || !wanted.ask || asked?.of === stats) return;
    const question = { of: stats, answer: '' };
    asked = question;
    const answer = await wanted.ask(sequence, facts).catch(() => ''); // another motion came between
    if (asked !== question) return;
    question.answer = answer;
    panel.setLive(answer);
  };

  /** Who left with the keyboard goes on where they came from. */
  const focusAgain = (): void => {
    const lost = document.activeElement === document.body;
    if (lost && focused instanceof HTMLElement && focused.checkVisibility()) focused.focus();
    focused = null;
  };

  const giveBack = async (left: Work | null): Promise<void> => {
    if (left) return again(left);
    // Of the guide's pages nothing is left: what is opened looks as on a first visit.
    store.set({ view: DEFAULT_VIEW });
    await openFirst();
  };

  /** As it was, moving where it moved. */
  const again = async (left: Work): Promise<void> => {
    const { playing } = left.state.play;
    if ((await files.again(left, null)) && playing) store.set({ play: { ...store.get().play, playing } });
  };

  /** Whoever presents goes on doing so on the next page. */
  const presenting = (): boolean => store.get().view.present !== null;
  window.addEventListener(
    'keydown',
    (event) => {
      const turn = CLICKS[event.key];
      if (!turn || !page || !presenting()) return;
      event.preventDefault();
      panel.turn(turn);
    },
    { capture: true },
  );

  const guide: Guide = {
    async open(fragment) {
      const wanted = [...TOUR, ...FIGURES].find(({ link }) => link === fragment);
      const state = wanted && readPermalink(wanted.state);
      if (!wanted || !state) return false;
      if (!page) {
        keep();
        before = returning > 0 ? comingBack : currentWork(store, workspace);
        focused = document.activeElement;
      }
      const enters = page === null && document.activeElement !== document.body;
      page = wanted;
      pin(wanted.link);
      panel.show(shown(wanted));
      place(panel.element, wanted.wide);
      if (enters) panel.focus();
      takeBack();
      takeBack = nothing;
      asked = null;
      turning += 1;
      const present = presenting() ? 'shape' : null;
      await files.show({ ...state, view: { ...state.view, present } }).finally(() => (turning -= 1));
      if (page !== wanted) return true;
      prepare(wanted);
      return true;
    },
    async close() {
      const left = before;
      if (!page) return;
      leave();
      focusAgain();
      returning += 1;
      comingBack = left;
      await giveBack(left).finally(() => (returning -= 1));
    },
    onOpened() {
      if (!page || turning > 0) return;
      if (before) files.openings.left(before);
      leave();
    },
    setFacts(facts) {
      if (!page) return;
      const open = facts && turning === 0 ? facts : null;
      if (open) void ask(page, open);
      panel.setLive((open && page.live?.(open)) ?? (page.ask && asked?.answer) ?? '');
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
      return turns || returning > 0;
    },
  };
  return guide;
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
