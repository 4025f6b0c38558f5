/** Reports changes of an element's size and of the device pixel ratio. */
export function listenToSize(host: Element, resized: () => void, zoomed: () => void, signal: AbortSignal): void {
  if (!globalThis.ResizeObserver) return window.addEventListener('resize', resized, { signal });
  const sizes = new ResizeObserver(resized);
  sizes.observe(host);
  const pixels = new ResizeObserver(zoomed);
  if ('devicePixelContentBoxSize' in ResizeObserverEntry.prototype)
    pixels.observe(host, { box: 'device-pixel-content-box' });
  signal.addEventListener('abort', () => {
    sizes.disconnect();
    pixels.disconnect();
  });
}
