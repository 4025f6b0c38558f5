/** Text of the current time's phase, over the shape. */
import type { Phase } from '../model/time-scale.ts';
import { button } from './controls.ts';
import type { Component } from './dom.ts';
import { h, setAttribute, setHidden, setText } from './dom.ts';

/** Faces that turned inside out. */
interface LostFaces {
  /** Share of all faces, in [0, 1]. */
  share: number;
  /** Whether one of these faces can be shown. */
  hasPlace: boolean;
}

export interface PhaseLabelProps {
  /** The phase; null shows none. */
  phase: Phase | null;
  lost: LostFaces;
}

/** Smaller shares of faces are invisible. */
const SEEN_SHARE = 0.001;

/** The current phase in large type, the meaning of its colour, and a button if faces have turned inside out. */
export function createPhaseLabel(onShowLost: () => void): Component<PhaseLabelProps> {
  const text = h('span', { 'data-testid': 'phase' });
  const lostText = h('span', {});
  const show = button({
    label: 'Show where',
    testId: 'lost-show',
    text: 'Show where',
    onClick: onShowLost,
  });
  const hint = h('div', { class: 'lost', 'data-testid': 'lost', hidden: true }, lostText, show);
  const element = h(
    'div',
    { class: 'phase-corner', hidden: true },
    hint,
    h('div', { class: 'phase' }, h('span', { class: 'dot' }), text),
  );
  return {
    element,
    update({ phase, lost }) {
      setHidden(element, phase === null);
      if (!phase) return;
      setAttribute(element, 'data-phase', phase.kind);
      setText(text, phase.text);
      setHidden(hint, !(lost.share >= SEEN_SHARE));
      setText(lostText, lostWords(lost.share, phase));
      setHidden(show, !lost.hasPlace);
    },
  };
}

function lostWords(share: number, { kind }: Phase): string {
  const percent = `${Number((100 * share).toPrecision(share < 0.1 ? 1 : 2))}\u00a0% of the faces fold over here`;
  return kind === 'beyond' ? `${percent}, this far from the keys.` : `${percent}.`;
}
