/**
 * The guide: pages that are states of the app, told of by their links. What was open before comes back when it is left,
 * unless the reader has opened something else meanwhile.
 */
import { DEFAULT_VIEW } from '../../model/state.ts';
import { createGuidePanel } from '../../ui/guide-panel.ts';
import type { GuidePanelProps } from '../../ui/guide-panel.ts';
import type { Work } from '../kept/work.ts';
import { currentWork } from '../kept/work.ts';
import type { PanelName } from '../panels/layout.ts';
import type { Store } from '../session/store.ts';
import type { Workspace } from '../session/workspace.ts';
import type { OpenFiles } from '../sources/open-files.ts';
import { readPermalink } from '../sources/permalink.ts';
import { FIGURES } from './figures.ts';
import type { Facts, GuidePage } from './guide-page.ts';
import { TOUR } from './tour.ts';
import { pressed, untilTouched, whenThere } from './when-there.ts';

export interface GuideParts {
  store: Store;
  workspace: Workspace;
  files: OpenFiles;
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
  /** What was open before the first page. */
  let before: Work | null = null;
  const panel = createGuidePanel(() => void guide.close());

  /** Of what the page on show has prepared. */
  let takeBack = nothing;
  const prepare = ({ panel: name, part, press, beside }: GuidePage): void => {
    const undone: (() => void)[] = [];
    if (beside) {
      frame({ href: beside.href, title: beside.framed });
      undone.push(() => frame(null));
    }
    if (name) undone.push(untilTouched(name, () => showPanel(name, part)));
    if (press) undone.push(whenThere(press, (control) => undone.push(pressed(control))));
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

  /** As it was, moving where it moved. */
  const again = async (left: Work): Promise<void> => {
    const { playing } = left.state.play;
    if ((await files.again(left, { quietly: true })) && playing) store.set({ play: { ...store.get().play, playing } });
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
        before = currentWork(store, workspace);
      }
      page = wanted;
      pin(wanted.link);
      panel.show(shown(wanted));
      place(panel.element, wanted.wide);
      takeBack();
      takeBack = nothing;
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
      if (left) await again(left);
      else {
        // Of the guide's pages nothing is left: what is opened looks as on a first visit.
        store.set({ view: DEFAULT_VIEW });
        await openFirst();
      }
    },
    onOpened() {
      if (!page || turning > 0) return;
      if (before) files.openings.left(before);
      leave();
    },
    setFacts(facts) {
      if (page) panel.setLive((facts && page.live?.(facts)) ?? '');
    },
    get isOpen() {
      return page !== null;
    },
  };
  return guide;
}

/** What the pages of a kind are called together. */
const KINDS = [
  { name: 'Tour', pages: TOUR },
  { name: 'The paper’s figures', pages: FIGURES },
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
