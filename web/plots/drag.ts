/** Follows a pointer from press to release. */
export function drag(
  element: SVGElement,
  { pointerId }: PointerEvent,
  onMove: (event: PointerEvent) => void,
  onEnd?: () => void,
): void {
  element.setPointerCapture(pointerId);
  const end = (): void => {
    element.removeEventListener('pointermove', onMove);
    for (const name of ENDS) element.removeEventListener(name, end);
    onEnd?.();
  };
  element.addEventListener('pointermove', onMove);
  for (const name of ENDS) element.addEventListener(name, end);
}

const ENDS = ['pointerup', 'pointercancel'] as const;
