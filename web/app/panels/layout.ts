/** Where everything stands on the page; on a small screen the keys and panels come up as sheets. */
import type { Presented } from '../../model/state.ts';
import { h, setAttribute } from '../../ui/dom.ts';
import { createFilmLabels } from '../../ui/film-labels.ts';
import type { FilmLabel } from '../../ui/film-labels.ts';
import { icon } from '../../ui/icons.ts';
import type { IconName } from '../../ui/icons.ts';
import { oneStop } from '../../ui/one-stop.ts';

export interface LayoutParts {
  header: HTMLElement;
  /** What lies over the viewport. */
  overlays: HTMLElement[];
  /** Progress and errors, on top of everything in the viewport. */
  messages: HTMLElement[];
  panels: HTMLElement[];
  keyStrip: HTMLElement;
  transport: HTMLElement;
  warnings: HTMLElement;
  status: HTMLElement;
  /** Asks about what has just been opened, beside the viewport. */
  opening: HTMLElement;
  /** Dialogs, drop zone, file inputs, toast. */
  floating: HTMLElement[];
}

export interface Layout {
  /** The viewer puts its canvas in here; takes the keyboard. */
  viewport: HTMLElement;
  mount(root: HTMLElement, parts: LayoutParts): void;
  /** Puts the guide's panel beside the viewport, with wider panels or not; null takes it away. */
  setGuide(panel: HTMLElement | null, wide?: boolean): void;
  /** Brings a panel in sight, or a part of it by its test id, where they stand beside the viewport. */
  showPanel(name: PanelName, part?: string): void;
  /** Another page in the place of the panels, where these stand beside the viewport; null: the panels. */
  setFramed(page: { href: string; title: string } | null): void;
  /** Names on the picture of a film strip. */
  showFilmLabels(labels: readonly FilmLabel[]): void;
  /** Pixels that bars and words take at the top and the bottom of each of the views, or of two that are `split`. */
  covered(views: number, split: boolean): { top: number; bottom: number };
  /** Nothing but this is on the page; null: all of it. */
  present(what: Presented | null): void;
}

/** Title and measures over a view; the line in words above the buttons, on a small screen. */
const TILE_LABEL_PX = 54;
const PHASE_PX = 34;
/** The line over four views beside a page of the guide on a small screen: words stand at the left of the shapes. */
const CROWDED_PX = 26;
/** The panels stand beside the viewport. */
const BESIDE = '(min-width: 768px)';
/** The row of the panels' names. */
const SIDE_NAV_PX = 45;
/** Titles and volumes beside a divider, where the shape is as wide as the view. */
const SPLIT_LABEL_PX = { small: 80, large: 108 };
/** How many times larger words are in a presentation. */
const LARGE_TYPE = 2.2;
/** A panel's heading this near to the top is where one is. */
const NEAR_PX = 24;

export type PanelName = 'motion' | 'shape' | 'analysis';
type Sheet = 'keys' | PanelName;

const SHEETS: readonly { name: Sheet; label: string; icon: IconName }[] = [
  { name: 'keys', label: 'Keys', icon: 'keys' },
  { name: 'motion', label: 'Motion', icon: 'motion' },
  { name: 'shape', label: 'Shape', icon: 'shape' },
  { name: 'analysis', label: 'Analysis', icon: 'chart' },
];

export function createLayout(): Layout {
  const filmLabels = createFilmLabels();
  const viewport = h('div', {
    class: 'picture',
    tabindex: 0,
    role: 'application',
    'data-testid': 'viewport',
    'aria-label': 'The shape. Arrow keys rotate it, plus and minus zoom, Shift with arrow keys moves it.',
  });
  let app: HTMLElement | null = null;
  return {
    viewport,
    showFilmLabels: filmLabels.update,
    covered: (views, split) => coveredHeights(viewport, views, split),
    setGuide(panel, wide = false) {
      if (app) setAttribute(app, 'data-wide', wide);
      const shown = app?.querySelector('.guide') ?? null;
      if (shown === panel) return; // put there again it would lose the focus
      shown?.remove();
      if (panel) app?.querySelector('main')?.before(panel);
      if (app) setAttribute(app, 'data-guide', panel !== null);
    },
    showPanel(name, part) {
      const panel = app?.querySelector<HTMLElement>(`[data-testid="panel-${name}"]`);
      const found = (part && panel?.querySelector<HTMLElement>(`[data-testid="${part}"]`)) || panel;
      const side = found?.closest('.side');
      if (!found || !side) return;
      const down = found.getBoundingClientRect().top - side.getBoundingClientRect().top;
      const names = panel?.querySelector<HTMLElement>(':scope > .legend')?.offsetHeight ?? 0;
      side.scrollTo({ top: side.scrollTop + down - SIDE_NAV_PX - (found === panel ? 0 : names) });
    },
    setFramed(page) {
      const side = app?.querySelector<HTMLElement>('.side');
      side?.querySelector('.framed')?.remove();
      if (page && side && matchMedia(BESIDE).matches)
        side.append(h('iframe', { class: 'framed', src: page.href, title: page.title }));
    },
    present(what) {
      if (!app) return;
      setAttribute(app, 'data-present', what);
      for (const figure of app.querySelectorAll<HTMLElement>('.figure[data-plot]'))
        setAttribute(figure, 'data-enlarged', figure.dataset['plot'] === what);
    },
    mount(root, parts) {
      app = h(
        'div',
        { class: 'app' },
        createSkips({ 'Go to the keys': '.key-list button', 'Go to the timeline': '.timeline' }),
        parts.header,
        h(
          'main',
          { class: 'viewport', 'aria-label': 'Viewport' },
          viewport,
          filmLabels.element,
          ...parts.overlays,
          h('div', { class: 'overlay-top' }, ...parts.messages),
        ),
        createSide(parts.panels),
        parts.opening,
        h('div', { class: 'deck' }, parts.keyStrip, parts.transport, parts.warnings),
        parts.status,
      );
      app.append(createTabs(app));
      root.replaceChildren(app, ...parts.floating);
    },
  };
}

/** Buttons at the top of the page, visible only while one has the focus: they skip the header and the panels. */
function createSkips(places: Record<string, string>): HTMLElement {
  const skipTo = (place: string) => (): void => {
    const target = document.querySelector<HTMLElement>(place);
    if (!target) return;
    // On a phone the keys are on a sheet, the first one.
    if (!target.checkVisibility()) document.querySelector<HTMLElement>('.tabs button')?.click();
    target.focus();
  };
  return h(
    'nav',
    { class: 'skips', 'aria-label': 'Skip' },
    ...Object.entries(places).map(([label, place]) =>
      h('button', { class: 'button', type: 'button', onclick: skipTo(place) }, label),
    ),
  );
}

function coveredHeights(viewport: HTMLElement, views: number, split: boolean): { top: number; bottom: number } {
  const app = viewport.closest<HTMLElement>('.app');
  const host = viewport.getBoundingClientRect();
  const height = (selector: string, from: (box: DOMRect) => number): number => {
    const box = document.querySelector(selector)?.getBoundingClientRect();
    return box && box.height > 0 ? Math.max(from(box), 0) : 0;
  };
  // A phone held sideways: words and buttons stand beside the shape.
  if (matchMedia('(max-height: 520px)').matches) return { top: 0, bottom: 0 };
  const small = matchMedia('(max-width: 767px)').matches;
  const crowded = small && views > 3 && app?.dataset['guide'] !== undefined && !app.dataset['sheet'];
  if (crowded) return { top: CROWDED_PX, bottom: 0 };
  const buttons = height('.view-buttons', (box) => host.bottom - box.top);
  const status = small ? height('.status-line', (box) => box.bottom - host.top) : 0;
  const bar = height(small ? '.colour-bar' : '.colour-bar[data-along]', (box) => box.bottom - host.top);
  const welcome = height('.welcome', (box) => box.bottom - host.top);
  const offer = height('.overlay-top > .offer:not([hidden])', (box) => box.bottom - host.top);
  const over = split && matchMedia('(max-width: 1023px)').matches;
  const type = app?.dataset['present'] ? LARGE_TYPE : 1;
  return {
    top: Math.max(Math.max(status, bar) + (views > 1 ? type * TILE_LABEL_PX : 0), welcome, offer),
    bottom:
      buttons +
      (small || over || type > 1 ? type * PHASE_PX : 0) +
      (over ? type * SPLIT_LABEL_PX[small ? 'small' : 'large'] : 0),
  };
}

/** The panels under each other, and a row of their names that stays in sight. */
function createSide(panels: HTMLElement[]): HTMLElement {
  const names = panels.map((panel) => panel.querySelector('h2')?.textContent ?? '');
  const buttons = names.map((name, index) =>
    h(
      'button',
      {
        type: 'button',
        'data-testid': `side-${index}`,
        onclick: () => {
          side.scrollTop = panels[index]!.offsetTop - row.offsetHeight;
        },
      },
      name,
    ),
  );
  const row = h('nav', { class: 'side-nav', 'aria-label': 'Parts of the options' }, ...buttons);
  oneStop(row);
  const side = h('aside', { class: 'side', 'aria-label': 'Options', tabindex: 0 }, row, ...panels);
  const mark = (): void => {
    const atEnd = side.scrollTop > 0 && side.scrollTop + side.clientHeight >= side.scrollHeight - 1;
    const passed = panels.filter((panel) => panel.offsetTop <= side.scrollTop + row.offsetHeight + NEAR_PX).length;
    const current = atEnd ? panels.length - 1 : Math.max(passed - 1, 0);
    buttons.forEach((button, index) => setAttribute(button, 'aria-current', index === current ? 'location' : null));
  };
  side.addEventListener('scroll', mark, { passive: true });
  new ResizeObserver(mark).observe(side);
  return side;
}

function createTabs(app: HTMLElement): HTMLElement {
  const buttons = SHEETS.map(({ name, label, icon: symbol }) =>
    h(
      'button',
      {
        type: 'button',
        'data-testid': `tab-${name}`,
        'aria-pressed': 'false',
        onclick: () => show(app.dataset['sheet'] === name ? null : name),
      },
      icon(symbol),
      h('span', {}, label),
    ),
  );
  const show = (sheet: Sheet | null): void => {
    setAttribute(app, 'data-sheet', sheet);
    SHEETS.forEach(({ name }, index) => setAttribute(buttons[index]!, 'aria-pressed', String(name === sheet)));
  };
  app.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && app.dataset['sheet']) show(null);
  });
  return h('nav', { class: 'tabs', 'aria-label': 'Panels' }, ...buttons);
}
