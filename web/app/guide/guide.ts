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
import { pressed, whenThere } from './when-there.ts';

export interface GuideParts {
  store: Store;
  workspace: Workspace;
  files: OpenFiles;
  /** Where its panel stands; null takes it away. */
  place(panel: HTMLElement | null): void;
  /** Brings options or plots in sight. */
  showPanel(name: PanelName, part?: string): void;
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

export function createGuide({ store, workspace, files, openFirst, place, showPanel, pin }: GuideParts): Guide {
  let page: GuidePage | null = null;
  /** It is opening a page of its own. */
  let turning = 0;
  /** What was open before the first page. */
  let before: Work | null = null;
  const panel = createGuidePanel(() => void guide.close());

  /** Of what the page on show has prepared. */
  let takeBack = nothing;
  const prepare = ({ panel: name, part, press }: GuidePage): void => {
    const undone: (() => void)[] = [];
    if (name) showPanel(name);
    if (name && part) undone.push(whenThere(part, () => showPanel(name, part)));
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

  const guide: Guide = {
    async open(fragment) {
      const wanted = [...TOUR, ...FIGURES].find(({ link }) => link === fragment);
      const state = wanted && readPermalink(wanted.state);
      if (!wanted || !state) return false;
      if (!page) before = currentWork(store, workspace);
      page = wanted;
      pin(wanted.link);
      panel.show(shown(wanted));
      place(panel.element);
      takeBack();
      takeBack = nothing;
      turning += 1;
      await files.show(state).finally(() => (turning -= 1));
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
