/** Takes a coordinate of a shape that is open in the app in another tab, and sends times and ends back. */
import { button, select } from '../ui/controls.ts';
import { h, setHidden, setText } from '../ui/dom.ts';
import type { SourceShape, PlaygroundMessage } from '../model/playground-channel.ts';
import { messageFrom, playgroundChannel } from '../model/playground-channel.ts';
import { timesOf } from './derived.ts';
import type { Panel } from './panels.ts';
import { LAYERS, MAX_KEYS, keysValidationError } from './state.ts';
import type { PlayState } from './state.ts';

export interface AppConnectionParts {
  get(): PlayState;
  /** Reports the new state after a coordinate was taken. */
  change(state: PlayState): void;
}

const TAKE = '#take';
const ASK_AGAIN_MS = 1000;
/** Limit for listed tabs. */
const MAX_SHAPES = 32;

export function createAppConnection({ get, change }: AppConnectionParts): Panel {
  let chosen = '';
  /** The link requests the first offered coordinate. */
  let asked = location.hash === TAKE;
  const none = h(
    'p',
    { class: 'hint', 'data-testid': 'no-shape' },
    'No shape is open in another tab of this browser. ',
    h('a', { href: './', target: '_blank', rel: 'noopener' }, 'Open a shape'),
    ' and return here to use its angles and stretches as values.',
  );
  const coordinate = select<string>('Coordinate', 'real-coordinate', [], (value) => {
    chosen = value;
    draw();
  });
  const take = button({
    label: 'Use the values of this coordinate',
    testId: 'take-real',
    text: 'Use it',
    onClick() {
      const [page, index] = chosen.split('|');
      const shape = shapes.get(page ?? '');
      if (shape) takeFrom(shape, Number(index));
    },
  });
  const back = button({
    label: 'Apply the times, ends, tensions and biases to the shape',
    testId: 'give-back',
    text: 'Apply times and ends',
    onClick: () => send(backMessage(get())),
  });
  const said = h('p', { class: 'hint', role: 'status', 'data-testid': 'real-said' });
  const buttons = h('div', { class: 'button-row' }, take, back);
  const some = h('div', { class: 'real-some', hidden: true }, coordinate.element, buttons, said);

  const takeFrom = (shape: SourceShape, index: number): void => {
    const state = takenState(get(), shape, index);
    const wrong = keysValidationError(state.keys);
    setText(said, wrong ? `These keys cannot be shown here: ${wrong}.` : '');
    if (!wrong) change(state);
  };
  const draw = (): void => {
    const choices = [...shapes.values()].flatMap(choicesOf);
    if (!choices.some(({ value }) => value === chosen)) chosen = choices[0]?.value ?? '';
    setHidden(none, choices.length > 0);
    setHidden(some, choices.length === 0);
    coordinate.update(chosen, choices);
    const { taken, keys } = get();
    const of = taken && shapes.get(taken.from);
    back.disabled = !of || of.times.length !== keys.length;
  };
  const { shapes, send } = listenForShapes({
    onShape(shape) {
      draw();
      if (asked && shape.coordinates.length > 0) takeFrom(shape, 0);
      asked = false;
    },
    onDone() {
      const where = window === window.parent ? 'in the other tab' : 'next to this page';
      setText(said, `The shape ${where} now moves like this. To revert, use Undo on its page.`);
    },
  });
  return {
    element: h('section', { class: 'real', 'data-testid': 'real' }, h('h2', {}, 'Use real data'), none, some),
    update: draw,
  };
}

function choicesOf({ page, title, coordinates }: SourceShape): { value: string; label: string }[] {
  return coordinates.map(({ name }, index) => ({ value: `${page}|${index}`, label: `${title}: ${name}` }));
}

interface Listener {
  /** A shape was opened or changed. */
  onShape(shape: SourceShape): void;
  /** A shape has used the returned values. */
  onDone(): void;
}

/** Lists the shapes open in other tabs, by page. Asks again whenever this page becomes visible. */
function listenForShapes({ onShape, onDone }: Listener) {
  const channel = 'BroadcastChannel' in window ? playgroundChannel() : null;
  const shapes = new Map<string, SourceShape>();
  let again = 0;
  const send = (message: PlaygroundMessage): void => channel?.postMessage(message);
  const ask = (): void => {
    shapes.clear();
    send({ type: 'ask' });
    // The app may still be starting, here or in another tab.
    window.clearTimeout(again);
    again = window.setTimeout(() => {
      if (shapes.size === 0 && !document.hidden) ask();
    }, ASK_AGAIN_MS);
  };
  channel?.addEventListener('message', ({ data }: MessageEvent<unknown>) => {
    const message = messageFrom(data);
    if (message?.type === 'open' && (shapes.has(message.shape.page) || shapes.size < MAX_SHAPES)) {
      shapes.set(message.shape.page, message.shape);
      onShape(message.shape);
    }
    if (message?.type === 'done') onDone();
  });
  document.addEventListener('visibilitychange', () => document.hidden || ask());
  window.addEventListener('pageshow', ask);
  return { shapes, send };
}

/** A state with the coordinate's values and the shape's own times and options. */
function takenState(state: PlayState, shape: SourceShape, index: number): PlayState {
  const { name, unit, values } = shape.coordinates[index]!;
  const count = Math.min(values.length, MAX_KEYS);
  const { boundary, startSpeed, endSpeed, tension, bias } = shape;
  const keys = values.slice(0, count).map((value, i) => ({
    time: shape.times[i]!,
    value,
    // The shape's next coordinate, for curves in the plane; the same one if there is no other.
    across: shape.coordinates[(index + 1) % shape.coordinates.length]!.values[i]!,
    tension: tension[i]!,
    bias: bias[i]!,
  }));
  const shaped = keys.some((key) => key.tension !== 0 || key.bias !== 0);
  const main = shaped ? 'shaped' : boundary;
  return {
    ...state,
    keys,
    layers: LAYERS.filter((layer) => layer === main || (layer === 'linear' && state.layers.includes(layer))),
    ends: boundary,
    speeds: [startSpeed, endSpeed],
    selected: Math.min(state.selected, count - 1),
    time: (keys[0]!.time + keys.at(-1)!.time) / 2,
    plane: false,
    spacing: 'hand',
    taken: { from: shape.page, shape: shape.title, name, unit, keys: values.length },
  };
}

function backMessage(state: PlayState): PlaygroundMessage {
  return {
    type: 'back',
    page: state.taken?.from ?? '',
    times: timesOf(state),
    boundary: state.ends,
    startSpeed: state.speeds[0],
    endSpeed: state.speeds[1],
    tension: state.keys.map(({ tension }) => tension),
    bias: state.keys.map(({ bias }) => bias),
  };
}
