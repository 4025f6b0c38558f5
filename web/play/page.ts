/** The playground: one state, its figures and controls, redrawn after changes. */
import { REFUSED, button } from '../ui/controls.ts';
import { h, setText } from '../ui/dom.ts';
import { createToast } from '../ui/messages.ts';
import { createBoard } from './board.ts';
import { sentence } from './captions.ts';
import { derive } from './derived.ts';
import type { Shown } from './derived.ts';
import { createEdits } from './edits.ts';
import { readLink, writeLink } from './link.ts';
import type { Panel } from './panels.ts';
import { createPlayer } from './player.ts';
import type { Player } from './player.ts';
import { INITIAL } from './state.ts';
import type { PlayState, LastAction } from './state.ts';

export interface PageParts {
  /** Elements at the top of the page, such as messages. */
  notices: readonly HTMLElement[];
  /** The panel that connects to the app, for a coordinate of a real shape. */
  appConnection: Panel;
  theme: HTMLElement;
  /** Whether the demonstration starts by itself. */
  playing: boolean;
  onError(error: unknown): void;
  /** A sentence about parts of the link that cannot be shown; null for none. */
  onIgnoredValues(sentence: string | null): void;
}

export interface PlayPage {
  element: HTMLElement;
  get(): PlayState;
  /** Sets a state as if by the user. */
  change(state: PlayState, lastAction: LastAction): void;
}

const SAY_MS = 600;
const LINK_MS = 300;

export function createPlayPage({
  notices,
  appConnection,
  theme,
  playing,
  onError,
  onIgnoredValues,
}: PageParts): PlayPage {
  const opened = readLink(location.hash);
  const first = opened?.state ?? INITIAL;
  let shown: Shown = { state: first, derived: derive(first), lastAction: 'key', lit: -1 };
  let frame = 0;
  const draw = (): void => {
    frame = 0;
    board.update(shown);
  };
  const show = (next: Partial<Shown>): void => {
    shown = { ...shown, ...next };
    if (frame === 0) frame = requestAnimationFrame(draw);
  };
  const showState = (state: PlayState, lastAction: LastAction): void =>
    show({ state, lastAction, derived: derive(state) });
  const get = (): PlayState => shown.state;
  const change = (state: PlayState, lastAction: LastAction): void => {
    player.stop();
    if (state === shown.state && lastAction === shown.lastAction) return;
    showState(state, lastAction);
    sayLater();
    linkLater();
  };
  const said = h('p', { class: 'visually-hidden', role: 'status', 'data-testid': 'said' });
  const sayLater = afterRest(SAY_MS, () => setText(said, sentence(shown)));
  const linkLater = afterRest(LINK_MS, () => {
    const link = writeLink(shown.state);
    history.replaceState(null, '', link ? `#${link}` : location.pathname + location.search);
  });
  const player = createPlayer(showState);
  const edits = createEdits(get, change, (lit) => lit !== shown.lit && show({ lit }));
  const board = createBoard(appConnection, edits, onError);
  const lead = createLead(player, () => change(INITIAL, 'natural'));
  const main = h('main', { class: 'play-main' }, lead, board.element, said);
  // A press or a key on the page ends the demonstration, except on its own button.
  const touch = ({ target }: Event): void => {
    if (!player.button.contains(target as Node)) player.stop();
  };
  for (const name of ['pointerdown', 'keydown'] as const) main.addEventListener(name, touch, { capture: true });
  window.addEventListener('hashchange', () => {
    const linked = readLink(location.hash);
    if (linked) change(linked.state, 'key');
    onIgnoredValues(linked?.ignoredValues ?? null);
  });
  if (playing && location.hash.length < 2) player.start();
  if (opened) onIgnoredValues(opened.ignoredValues);
  show({});
  const toast = createToast();
  main.addEventListener(REFUSED, ({ detail }: CustomEventInit<string>) => toast.say(detail ?? ''));
  const element = h('div', { class: 'play' }, createHeader(theme), ...notices, main, toast.element);
  return { element, get, change };
}

function createHeader(theme: HTMLElement): HTMLElement {
  return h(
    'header',
    { class: 'play-header' },
    h('a', { class: 'wordmark', href: './', title: 'To the app' }, 'shape', h('span', {}, 'spline')),
    h('div', { class: 'spacer' }),
    theme,
  );
}

/** The introduction of the page. */
function createLead(player: Player, onReset: () => void): HTMLElement {
  const reset = button({ label: 'Reset the playground', testId: 'reset', icon: 'reset', onClick: onReset });
  return h(
    'div',
    { class: 'lead' },
    h('h1', {}, 'The bent ruler'),
    h(
      'p',
      {},
      'A motion through key poses is this picture, repeated for every coordinate of the shape. Drag a key. Switch curves on and off.',
    ),
    h('div', { class: 'demonstration' }, player.scene, player.button, reset),
  );
}

/** Calls `work` after a pause of `ms` without further calls. */
function afterRest(ms: number, work: () => void): () => void {
  let timer = 0;
  return () => {
    window.clearTimeout(timer);
    timer = window.setTimeout(work, ms);
  };
}
