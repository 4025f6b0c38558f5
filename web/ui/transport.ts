/** Play, loop, speed and time fields around the timeline. */
import type { LoopMode, Play } from '../model/state.ts';
import { SPEEDS } from '../model/state.ts';
import { button, numberField, select, tooltip } from './controls.ts';
import type { Component, Fields } from './dom.ts';
import { h, memo, setAttribute, setField, setText } from './dom.ts';
import type { IconName } from './icons.ts';
import { setIcon } from './icons.ts';
import type { Range } from '../model/time-scale.ts';
import { formatMoment, momentWords } from '../model/frames.ts';

export interface TransportProps {
  play: Play;
  time: number;
  range: Range;
  periodic: boolean;
  disabled: boolean;
}

export interface TransportEvents {
  onTogglePlay(): void;
  onLoop(loop: LoopMode): void;
  onSpeed(speed: number): void;
  onSeek(t: number): void;
}

const LOOPS: Record<LoopMode, { next: LoopMode; icon: IconName; label: string }> = {
  bounce: { next: 'loop', icon: 'bounce', label: 'Plays back and forth' },
  loop: { next: 'once', icon: 'loop', label: 'Plays in a loop' },
  once: { next: 'bounce', icon: 'once', label: 'Plays once' },
};

/** Layout with the timeline in the middle and the clock menu at the end. */
export function createTransport(
  timeline: HTMLElement,
  clockMenu: HTMLElement,
  events: TransportEvents,
): Component<TransportProps> {
  const buttons = createPlayButtons(events);
  const time = createTimeField(events);
  const element = h(
    'section',
    { class: 'transport', 'aria-label': 'Time' },
    buttons.element,
    timeline,
    h('div', { class: 'transport-time' }, ...time.elements, clockMenu),
  );
  return {
    element,
    update(props) {
      buttons.update({ play: props.play, disabled: props.disabled, periodic: props.periodic });
      time.update(props);
    },
  };
}

type PlayButtonsProps = Pick<TransportProps, 'play' | 'disabled' | 'periodic'>;

function createPlayButtons(events: TransportEvents): Component<PlayButtonsProps> {
  let loop: LoopMode = 'bounce';
  const play = button({
    label: 'Play',
    testId: 'play',
    icon: 'play',
    shortcut: 'Space',
    kind: 'primary',
    onClick: () => events.onTogglePlay(),
  });
  const loopButton = button({
    label: 'Loop',
    testId: 'loop',
    icon: 'bounce',
    shortcut: 'L',
    onClick: () => events.onLoop(LOOPS[loop].next),
  });
  const speed = select(
    'Speed',
    'speed',
    SPEEDS.map((value) => ({ value: String(value), label: `${value}×` })),
    (value) => events.onSpeed(Number(value)),
    ', and .',
  );
  speed.element.classList.add('compact');
  const draw = memo(({ play: state, disabled, periodic }: PlayButtonsProps) => {
    const label = state.playing ? 'Pause' : 'Play';
    setIcon(play, state.playing ? 'pause' : 'play');
    setAttribute(play, 'aria-label', label);
    setAttribute(play, 'title', tooltip(label, 'Space'));
    loop = state.loop;
    const shown = periodic && loop === 'bounce' ? 'loop' : loop;
    const words = `${LOOPS[shown].label}; click to change`;
    setIcon(loopButton, LOOPS[shown].icon);
    setAttribute(loopButton, 'aria-label', words);
    setAttribute(loopButton, 'title', tooltip(words, 'L'));
    setAttribute(loopButton, 'data-loop', shown);
    speed.update(String(state.speed));
    for (const control of [play, loopButton]) control.disabled = disabled;
  });
  return { element: h('div', { class: 'transport-buttons' }, play, loopButton, speed.element), update: draw };
}

const TYPE_TIME = 'Time in seconds; type a number to go there';

/** The time or the frame, as an editable number. */
function createTimeField({ onSeek }: TransportEvents): Fields<TransportProps> {
  let fps: number | null = null;
  const time = numberField({
    label: TYPE_TIME,
    testId: 'time',
    onInput: (value) => onSeek(fps === null ? value : value / fps),
  });
  time.classList.add('time');
  const unit = h('span', { class: 'unit', 'data-testid': 'time-unit' });
  return {
    elements: [time, unit],
    update({ play, time: t, range, disabled }) {
      ({ fps } = play);
      time.disabled = disabled;
      setField(time, formatMoment(t, range, fps));
      setText(unit, fps === null ? 's' : 'f');
      setAttribute(time, 'aria-label', fps === null ? TYPE_TIME : 'Frame; type a number to go there');
      const frameWords = `Frame, at ${momentWords(t, range, null)}; type a number to go there`;
      setAttribute(time, 'title', fps === null ? TYPE_TIME : frameWords);
      setAttribute(time, 'step', fps === null ? stepFor(range) : 1);
    },
  };
}

/** The field accepts any number. Its arrows move by a hundredth of the range. */
function stepFor([start, end]: Range): string {
  return String(Number(((end - start) / 100).toPrecision(1)));
}
