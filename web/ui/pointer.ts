/** Follows pointers from press to release. */

export interface Dragging {
  onMove(event: PointerEvent): void;
  onEnd?(): void;
}

/** Whether a finger, a pen or the mouse's first button went down, with no other finger down before. */
export function isPress(event: PointerEvent): boolean {
  return event.button === 0 && event.isPrimary;
}

/** Follows one pointer. A second finger ends the drag, because it starts another gesture. */
export function drag(element: HTMLElement, start: PointerEvent, { onMove, onEnd }: Dragging): void {
  element.setPointerCapture(start.pointerId);
  const move = (event: PointerEvent): void => {
    if (event.pointerId === start.pointerId) onMove(event);
  };
  const end = (event: PointerEvent): void => {
    const another = event.type === 'pointerdown';
    if ((event.pointerId === start.pointerId) === another) return;
    element.removeEventListener('pointermove', move);
    for (const name of ENDS) element.removeEventListener(name, end);
    onEnd?.();
  };
  element.addEventListener('pointermove', move);
  for (const name of ENDS) element.addEventListener(name, end);
}

const ENDS = ['pointerup', 'pointercancel', 'pointerdown'] as const;

export interface Gestures {
  /** Values above 1 zoom in; `x` is the centre, in page pixels. */
  onZoom(factor: number, x: number): void;
  /** Pixels by which to move the content to the right. */
  onPan(pixels: number): void;
}

const WHEEL_ZOOM = 0.002;
const LINE_PX = 16;

/** Zooms with wheel and pinch. Pans with Shift and wheel, sideways wheel, two fingers, and the middle button. */
export function listenToGestures(element: HTMLElement, { onZoom, onPan }: Gestures): void {
  element.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINE_PX : 1;
      const sideways = event.shiftKey
        ? event.deltaY || event.deltaX
        : Math.abs(event.deltaX) > Math.abs(event.deltaY)
          ? event.deltaX
          : 0;
      if (sideways !== 0) onPan(-sideways * unit);
      // Browsers report a trackpad pinch as a wheel event with Ctrl and small steps.
      else onZoom(Math.exp(-event.deltaY * unit * WHEEL_ZOOM * (event.ctrlKey ? 5 : 1)), event.clientX);
    },
    { passive: false },
  );

  element.addEventListener('pointerdown', (event) => {
    if (event.button !== 1) return;
    event.preventDefault();
    let x = event.clientX;
    drag(element, event, {
      onMove: (move) => {
        onPan(move.clientX - x);
        x = move.clientX;
      },
    });
  });

  const fingers = new Map<number, number>();
  const spread = (): { middle: number; width: number } => {
    const [a = 0, b = 0] = fingers.values();
    return { middle: (a + b) / 2, width: Math.max(Math.abs(a - b), 8) };
  };
  element.addEventListener('pointerdown', (event) => {
    if (event.pointerType === 'touch') fingers.set(event.pointerId, event.clientX);
  });
  element.addEventListener('pointermove', (event) => {
    if (!fingers.has(event.pointerId)) return;
    const before = spread();
    fingers.set(event.pointerId, event.clientX);
    if (fingers.size !== 2) return;
    const now = spread();
    onPan(now.middle - before.middle);
    onZoom(now.width / before.width, now.middle);
  });
  for (const end of ['pointerup', 'pointercancel'] as const)
    element.addEventListener(end, (event) => fingers.delete(event.pointerId));
}

/**
 * Focuses an element after a press. Browsers treat this as keyboard focus, so the focus ring waits for the first key.
 */
export function focusPressed(element: HTMLElement): void {
  if (element.classList.contains('pressed')) return;
  element.classList.add('pressed');
  element.focus({ preventScroll: true });
  const ended = new AbortController();
  const end = (): void => {
    element.classList.remove('pressed');
    ended.abort();
  };
  element.addEventListener('blur', end, { signal: ended.signal });
  element.addEventListener('keydown', end, { signal: ended.signal });
}

/**
 * Withholds a finger's first moves from inner listeners until it has moved further sideways than vertically. Vertical
 * moves scroll the page, and the browser takes over the pointer when it recognises them.
 */
export function leaveScrolling(element: HTMLElement): void {
  let start: PointerEvent | null = null;
  element.addEventListener(
    'pointerdown',
    (event) => {
      start = event.pointerType === 'touch' && event.isPrimary ? event : null;
    },
    { capture: true },
  );
  element.addEventListener(
    'pointermove',
    (event) => {
      if (event.pointerId !== start?.pointerId) return;
      if (Math.abs(event.clientX - start.clientX) > Math.abs(event.clientY - start.clientY)) start = null;
      else event.stopPropagation();
    },
    { capture: true },
  );
}
