/**
 * Pointer positions for OrbitControls, which measures in pixels of the window. A page can rotate, scale or tilt the
 * viewer's container; then a drag has to be measured in pixels of the element itself.
 */
import type { OrbitControls } from 'three/addons/controls/OrbitControls.js';

type Position = Pick<PointerEvent, 'clientX' | 'clientY' | 'pageX' | 'pageY'>;

/** Handlers of OrbitControls that read positions. */
const HANDLERS = ['_onMouseDown', '_onMouseMove', '_onTouchStart', '_onTouchMove'] as const;

type Inner = Partial<Record<(typeof HANDLERS)[number] | '_customWheelEvent', (event: PointerEvent) => object>>;

export function measureInOwnPixels(controls: OrbitControls, element: HTMLElement): void {
  const inner = controls as unknown as Inner;
  for (const name of HANDLERS) {
    const handle = inner[name];
    if (handle) inner[name] = (event) => handle(moved(event, element, 1, 1));
  }
  const wheel = inner._customWheelEvent?.bind(inner);
  // The point under the pointer stays in place, as a share of the box around the element.
  if (wheel)
    inner._customWheelEvent = (event) => {
      const { width, height } = element.getBoundingClientRect();
      const { clientX, clientY } = moved(event, element, width / element.clientWidth, height / element.clientHeight);
      return { ...wheel(event), clientX, clientY };
    };
}

/** The parts of the event that the handlers read. OrbitControls also calls them with positions that it kept. */
function moved(event: PointerEvent, element: HTMLElement, scaleX: number, scaleY: number): PointerEvent {
  const { offsetX, offsetY, pointerId, button, ctrlKey, metaKey, shiftKey } = event;
  if (offsetX === undefined) return event;
  const { left, top } = element.getBoundingClientRect();
  const [x, y] = [left + offsetX * scaleX, top + offsetY * scaleY];
  const position: Position = { clientX: x, clientY: y, pageX: x, pageY: y };
  return { ...position, pointerId, button, ctrlKey, metaKey, shiftKey } as PointerEvent;
}
