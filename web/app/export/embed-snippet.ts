/** HTML that embeds the open shape: the element, beside the project's GLB with keys and options. */
import { orbitWords } from '../../model/camera-words.ts';
import type { AppState } from '../../model/state.ts';

const COLOURS: readonly string[] = ['phase', 'patches'];

/** `file`: the project's GLB, beside the page; `alt`: text alternative. */
export function embedSnippet({ play, view, doc }: AppState, file: string, alt: string): string {
  const compared = view.compare.filter((method) => method !== doc.motion.method);
  const attributes: Record<string, string> = {
    src: encodeURIComponent(file),
    controls: '',
    ...(play.loop === 'once' ? {} : { autoplay: '', loop: play.loop }),
    ...(play.between ? { range: play.between.join(' ') } : {}),
    ...(compared.length > 0 ? { compare: compared.join(' ') } : {}),
    ...(COLOURS.includes(view.colouring) ? { colour: view.colouring } : {}),
    ...(view.camera ? { 'camera-orbit': orbitWords(view.camera) } : {}),
    alt,
  };
  const words = Object.entries(attributes).map(([name, value]) => (value === '' ? name : `${name}="${quoted(value)}"`));
  return [
    '<script type="module" src="shapespline/cdn.js"></script>',
    `<shape-spline ${words.join(' ')}></shape-spline>`,
  ].join('\n');
}

/** A page with only the element, filling the window. */
export const embedPage = (title: string, snippet: string): string => `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${quoted(title)}</title>
<style>
html, body { height: 100%; margin: 0; }
shape-spline { display: block; width: 100%; height: 100%; }
shape-spline:not(:defined) { height: 0; }
shape-spline:defined ~ p { display: none; }
p { padding: 24px; animation: late 4s; }
@keyframes late { 0%, 100% { visibility: hidden; } }
</style>
</head>
<body>
${snippet}
<p>If the shape does not appear, its script cannot run here. This page needs JavaScript and a web server: a browser runs
no modules from a file.</p>
</body>
</html>
`;

const quoted = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');
