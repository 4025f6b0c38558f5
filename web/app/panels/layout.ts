/** The page layout. On small screens, keys and panels open as sheets. */
import type { Presented } from '../../model/state.ts';
import type { ViewerEvents } from '../../viewer/viewer.ts';
import { h, setAttribute } from '../../ui/dom.ts';
import { createFilmLabels } from '../../ui/film-labels.ts';
import type { FilmLabel } from '../../ui/film-labels.ts';
import { icon } from '../../ui/icons.ts';
import type { IconName } from '../../ui/icons.ts';
import { rovingTabindex } from '../../ui/roving-tabindex.ts';

export interface LayoutParts {
  header: HTMLElement;
  /** Elements over the viewport. */
  overlays: HTMLElement[];
  /** Progress and errors, above all other elements in the viewport. */
  messages: HTMLElement[];
  panels: HTMLElement[];
  keyStrip: HTMLElement;
  transport: HTMLElement;
  warnings: HTMLElement;
  status: HTMLElement;
  /** The import dialog, beside the viewport. */
  opening: HTMLElement;
  /** Dialogs, drop zone, file inputs, toast. */
  floating: HTMLElement[];
}

type Covered = ViewerEvents['covered'];

export interface Layout {
  /** Container of the viewer's canvas; receives keyboard focus. */
  viewport: HTMLElement;
  mount(root: HTMLElement, parts: LayoutParts): void;
  /** Puts the guide's panel beside the viewport, optionally with wider panels; null removes it. */
  setGuide(panel: HTMLElement | null, wide?: boolean): void;
  /** Scrolls to a panel, or to its part with this id, if panels are beside the viewport. */
  showPanel(name: PanelName, part?: string): void;
  /** Replaces the panels beside the viewport by another page; null restores them. */
  setFramed(page: { href: string; title: string } | null): void;
  /** Shows names on the image of a film strip. */
  showFilmLabels(labels: readonly FilmLabel[]): void;
  covered: Covered;
  /** Hides everything else; null shows the whole page. */
  present(what: Presented | null): void;
}

/** Height of title and measures over a view. On small screens, also of the text line above the buttons. */
const TILE_LABEL_PX = 54;
/** Height of the title in the corner of a film strip. */
const STRIP_LABEL_PX = 26;
const STRIP_FOOT_PX = 8;
const PHASE_PX = 34;
/**
 * Height of the text line over four views, beside a guide page on a small screen. The view names are left of the
 * shapes.
 */
const CROWDED_PX = 26;
/** Up to this width, a guide page is below the shape. It then hides most buttons over film strips. */
const GUIDE_BELOW = '(max-width: 1180px)';
/** From this width, panels are beside the viewport. */
const BESIDE = '(min-width: 768px)';
/** Height of the panel navigation. */
const SIDE_NAV_PX = 45;
/** Height of titles and volumes beside a divider, for a shape as wide as the view. */
const SPLIT_LABEL_PX = { small: 80, large: 108 };
/** Text scale of a presentation. */
const LARGE_TYPE = 2.2;
/** A panel is current when its heading is within this distance of the top. */
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
    covered: (...of) => coveredHeights(viewport, ...of),
    setGuide(panel, wide = false) {
      if (app) setAttribute(app, 'data-wide', wide);
      const shown = app?.querySelector('.guide') ?? null;
      if (shown === panel) return; // Moving it again would lose the focus.
      shown?.remove();
      if (panel) app?.querySelector('main')?.before(panel);
      if (app) setAttribute(app, 'data-guide', panel !== null);
    },
    showPanel(name, part) {
      const panel = app?.querySelector<HTMLElement>(`#panel-${name}`);
      const found = (part && panel?.querySelector<HTMLElement>(`#${part}`)) || panel;
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
        createSidebar(parts.panels),
        parts.opening,
        h('div', { class: 'deck' }, parts.keyStrip, parts.transport, parts.warnings),
        parts.status,
      );
      app.append(createTabs(app));
      root.replaceChildren(app, ...parts.floating);
    },
  };
}

/** Skip links at the top of the page, visible only while focused, past the header and the panels. */
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

function coveredHeights(viewport: HTMLElement, ...of: Parameters<Covered>): ReturnType<Covered> {
  const [views, split, strip] = of;
  const app = viewport.closest<HTMLElement>('.app');
  const host = viewport.getBoundingClientRect();
  const height = (selector: string, from: (box: DOMRect) => number): number => {
    const box = document.querySelector(selector)?.getBoundingClientRect();
    return box && box.height > 0 ? Math.max(from(box), 0) : 0;
  };
  // On a phone in landscape, text and buttons are beside the shape.
  if (matchMedia('(max-height: 520px)').matches) return { top: 0, bottom: 0 };
  const type = app?.dataset['present'] ? LARGE_TYPE : 1;
  const small = matchMedia('(max-width: 767px)').matches;
  const guided = app?.dataset['guide'] !== undefined && !app.dataset['sheet'];
  if (strip && guided && matchMedia(GUIDE_BELOW).matches) return { top: type * STRIP_LABEL_PX, bottom: STRIP_FOOT_PX };
  if (small && views > 3 && guided) return { top: CROWDED_PX, bottom: 0 };
  const buttons = height('.view-buttons', (box) => host.bottom - box.top);
  const status = small ? height('.status-line', (box) => box.bottom - host.top) : 0;
  const bar = height(small ? '.colour-bar' : '.colour-bar[data-along]', (box) => box.bottom - host.top);
  const welcome = height('.welcome', (box) => box.bottom - host.top);
  const offer = height('.overlay-top > .offer:not([hidden])', (box) => box.bottom - host.top);
  const over = split && matchMedia('(max-width: 1023px)').matches;
  const label = strip ? STRIP_LABEL_PX : TILE_LABEL_PX;
  return {
    top: Math.max(Math.max(status, bar) + (views > 1 ? type * label : 0), welcome, offer),
    bottom:
      buttons +
      (small || over || type > 1 ? type * PHASE_PX : 0) +
      (over ? type * SPLIT_LABEL_PX[small ? 'small' : 'large'] : 0),
  };
}

/** The panels in one column, with navigation that stays visible. */
function createSidebar(panels: HTMLElement[]): HTMLElement {
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
  const row = h('nav', { class: 'side-nav', 'aria-label': 'Sections of the options' }, ...buttons);
  rovingTabindex(row);
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
