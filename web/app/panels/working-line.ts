/** Progress of a measurement, with a cancel button. */
import type { Progress } from '../../engine/api/types.ts';
import { button } from '../../ui/controls.ts';
import { h, setHidden, setStyle, setText } from '../../ui/dom.ts';

export interface WorkingLine {
  element: HTMLElement;
  /** `stoppable`: with the cancel button. */
  show(working: boolean, stoppable?: boolean): void;
  update(progress: Progress): void;
}

/** Hidden until shown. `cancelLabel`: of the cancel button. */
export function createWorkingLine(name: string, cancelLabel: string, onCancel: () => void): WorkingLine {
  const stage = h('span', { class: 'muted stage', role: 'status' });
  const bar = h('div', { class: 'bar' });
  const cancel = button({ label: cancelLabel, testId: `${name}-cancel`, text: 'Cancel', onClick: onCancel });
  const element = h(
    'div',
    { class: 'field row', hidden: true, 'data-testid': `${name}-working` },
    h('div', { class: 'progress-text' }, stage, h('div', { class: 'meter' }, bar)),
    cancel,
  );
  return {
    element,
    show(working, stoppable = true) {
      setHidden(element, !working);
      setHidden(cancel, !stoppable);
    },
    update({ stage: now, fraction }) {
      setText(stage, now);
      setStyle(bar, 'width', `${(100 * fraction).toFixed(1)}%`);
    },
  };
}
