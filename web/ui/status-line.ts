/** A status line: the open shape, its frame time, and the number of warnings, which opens the list. */
import type { Component } from './dom.ts';
import { h, memo, setAttribute, setHidden, setText } from './dom.ts';
import { icon } from './icons.ts';

export interface StatusProps {
  keys: number;
  vertices: number;
  faces: number;
  /** Milliseconds of the last frame in the worker, or null before the first. */
  ms: number | null;
  warnings: number;
  offline: boolean;
}

/** onWarnings receives the pressed button. */
export function createStatusLine(onWarnings: (from: HTMLElement) => void): Component<StatusProps> {
  const keys = h('span', { 'data-testid': 'status-keys' });
  const vertices = h('span', { class: 'vertices', 'data-testid': 'status-vertices' });
  const faces = h('span', { 'data-testid': 'status-faces' });
  const ms = h('span', {
    'data-testid': 'status-ms',
    class: 'ms',
    title: 'Time to compute the shape on the screen',
  });
  const offline = h('span', { hidden: true }, 'offline');
  const count = h('span', {});
  const warnings: HTMLButtonElement = h(
    'button',
    {
      type: 'button',
      class: 'button quiet warning-count',
      'data-testid': 'warning-count',
      hidden: true,
      title: 'Show the warnings',
      onclick: () => onWarnings(warnings),
    },
    icon('warning'),
    count,
  );
  const element = h(
    'footer',
    { class: 'status-line', 'data-testid': 'status' },
    keys,
    vertices,
    faces,
    ms,
    warnings,
    offline,
  );

  const drawCounts = memo((props: Omit<StatusProps, 'ms'>) => {
    setText(keys, plural(props.keys, 'key', 'keys'));
    setText(vertices, plural(props.vertices, 'vertex', 'vertices'));
    setText(faces, plural(props.faces, 'face', 'faces'));
    setAttribute(element, 'data-empty', props.keys === 0);
    setHidden(offline, !props.offline);
    setHidden(warnings, props.warnings === 0);
    setText(count, plural(props.warnings, 'warning', 'warnings'));
  });

  return {
    element,
    update({ ms: time, ...rest }) {
      drawCounts(rest);
      const digits = time !== null && time < 9.95 ? 1 : 0;
      setText(ms, time === null ? '' : `${time.toFixed(digits)} ms per frame`);
    },
  };
}

export function plural(count: number, one: string, many: string): string {
  return `${count.toLocaleString('en')} ${count === 1 ? one : many}`;
}
