/** The element's style, as a style sheet created by script. Unlike a <style> element, strict policies allow it. */
const CSS = `
:host { display: block; contain: strict; inline-size: 100%; aspect-ratio: 3 / 2; min-block-size: 120px;
  position: relative; font: 14px system-ui, sans-serif;
  --fore: var(--shape-spline-foreground, light-dark(#181b1f, #eceef0));
  --key: var(--shape-spline-key, #0072b2);
  color: var(--fore); background: var(--shape-spline-background, light-dark(#f4f5f6, #1e2125)); }
:host([hidden]), [hidden] { display: none !important; }
[part=viewport], .poster { position: absolute; inset: 0; }
.poster { background: var(--shape-spline-background, light-dark(#f4f5f6, #1e2125)); }
[part=viewport] > canvas { display: block; }
[part=viewport]:focus-visible { outline: 2px solid var(--key); outline-offset: -2px; }
.poster img { inline-size: 100%; block-size: 100%; object-fit: contain; }
[part=progress] { position: absolute; inset-block-start: 0; inset-inline: 0; block-size: 3px; transform-origin: 0 0;
  background: var(--shape-spline-progress, var(--key)); }
[part=name] { position: absolute; block-size: 24px; line-height: 24px; padding: 0 8px; box-sizing: border-box;
  overflow: hidden; text-align: center; text-overflow: ellipsis; white-space: nowrap; pointer-events: none; }
[part=message] { position: absolute; inset: 0; margin: auto; box-sizing: border-box; inline-size: fit-content;
  block-size: fit-content; max-inline-size: min(480px, 100% - 16px); max-block-size: calc(100% - 16px);
  overflow: auto; padding: 12px 16px; border-radius: 6px; text-align: center; overflow-wrap: anywhere;
  background: var(--shape-spline-background, light-dark(#f4f5f6, #1e2125)); }
[part=retry] { display: block; margin: 8px auto 0; min-block-size: 44px; padding: 0 16px; font: inherit; }
[part=controls] { position: absolute; inset-inline: 4px 20px; inset-block-end: 6px; display: flex; gap: 8px;
  align-items: center; block-size: 44px; }
[part=play] { inline-size: 44px; block-size: 44px; padding: 10px; border: 0; background: none; color: inherit;
  cursor: pointer; }
[part=play] svg { inline-size: 100%; fill: none; stroke: currentColor; stroke-width: 1.6; }
[part=timeline] { position: relative; flex: 1; block-size: 44px; direction: ltr; cursor: pointer; touch-action: pan-y; }
[part=timeline]::before { content: ''; position: absolute; inset: 21px 0; background: currentColor; opacity: 0.35; }
[part=key], [part=thumb] { position: absolute; inset-block-start: 50%; translate: -50% -50%; border-radius: 50%;
  pointer-events: none; }
[part=key] { inline-size: 10px; block-size: 10px; background: var(--key); }
[part=thumb] { inline-size: 18px; block-size: 18px; background: currentColor; }
@media (forced-colors: active) {
  [part=timeline]::before, [part=key], [part=thumb] { forced-color-adjust: none; }
  [part=timeline]::before, [part=thumb] { background: CanvasText; opacity: 1; }
  [part=key] { background: Highlight; }
  [part=key], [part=thumb] { outline: 2px solid Canvas; }
  [part=progress] { forced-color-adjust: none; background: Highlight; }
}
.caption { position: absolute; inset-block-start: 8px; inset-inline: 12px; pointer-events: none; }
`;

const sheets = new WeakMap<Document, CSSStyleSheet>();

/**
 * One style sheet per document; null for a document without a window, or without support for constructed style sheets.
 */
export function styleSheet(of: Document): CSSStyleSheet | null {
  const known = sheets.get(of);
  const view = of.defaultView;
  if (known || !view?.CSSStyleSheet?.prototype.replaceSync) return known ?? null;
  const sheet = new view.CSSStyleSheet();
  sheet.replaceSync(CSS);
  sheets.set(of, sheet);
  return sheet;
}
