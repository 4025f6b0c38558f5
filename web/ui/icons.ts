/** Line icons on a 20 x 20 grid, drawn for this app, in the colour of the adjacent text. */
import { svg } from './dom.ts';

const PATHS = {
  play: 'M6.5 4.2v11.6L16 10z',
  pause: 'M7 4.5v11M13 4.5v11',
  once: 'M3.5 10h11M11 6.5l3.5 3.5-3.5 3.5M17 5.5v9',
  loop: 'M4 10.5V9a3.5 3.5 0 0 1 3.5-3.5H15M12.5 3L15 5.5 12.5 8M16 9.5V11a3.5 3.5 0 0 1-3.5 3.5H5M7.5 17L5 14.5 7.5 12',
  sides: 'M7 6l-4 4 4 4M13 6l4 4-4 4',
  bounce: 'M3.5 10h13M6.5 7l-3 3 3 3M13.5 7l3 3-3 3',
  clock: 'M10 2.8a7.2 7.2 0 1 0 0 14.4 7.2 7.2 0 0 0 0-14.4zM10 6v4.2l2.8 1.8',
  fit: 'M3.5 7V4.5a1 1 0 0 1 1-1H7M13 3.5h2.5a1 1 0 0 1 1 1V7M16.5 13v2.5a1 1 0 0 1-1 1H13M7 16.5H4.5a1 1 0 0 1-1-1V13M7.5 7.5h5v5h-5z',
  front: 'M4 7.5h8.5V16H4zM4 7.5L7.5 4H16l-3.5 3.5M16 4v8.5L12.5 16',
  undo: 'M7.5 4L4 7.5 7.5 11M4.5 7.5H12a4 4 0 0 1 0 8H8.5',
  redo: 'M12.5 4L16 7.5 12.5 11M15.5 7.5H8a4 4 0 0 0 0 8h3.5',
  plus: 'M10 4v12M4 10h12',
  minus: 'M4 10h12',
  close: 'M5 5l10 10M15 5L5 15',
  open: 'M3 15V5.5A1 1 0 0 1 4 4.5h3.5l2 2H15a1 1 0 0 1 1 1V9M3 15l2-6h13l-2.2 6.3a1 1 0 0 1-1 .7H4a1 1 0 0 1-1-1z',
  download: 'M10 3.5v9M6.5 9.5l3.5 3.5 3.5-3.5M4 16.5h12',
  help: 'M7.5 7.7a2.6 2.6 0 1 1 3.7 2.3c-.8.4-1.2.9-1.2 1.8M10 14.6v.1M10 2.8a7.2 7.2 0 1 0 0 14.4 7.2 7.2 0 0 0 0-14.4z',
  light:
    'M10 6.7a3.3 3.3 0 1 0 0 6.6 3.3 3.3 0 0 0 0-6.6zM10 2.5V4M10 16v1.5M2.5 10H4M16 10h1.5M4.7 4.7l1 1M14.3 14.3l1 1M4.7 15.3l1-1M14.3 5.7l1-1',
  dark: 'M16.3 11.8A6.7 6.7 0 0 1 8.2 3.7a6.7 6.7 0 1 0 8.100 8.100z',
  system: 'M3.5 4.5h13v9h-13zM7.5 16.5h5M10 13.5v3',
  warning: 'M10 3.5l7 12.5H3zM10 8.5v3.5M10 14v.1',
  info: 'M10 9v5M10 6.3v.1M10 2.8a7.2 7.2 0 1 0 0 14.4 7.2 7.2 0 0 0 0-14.4z',
  eye: 'M2.5 10S5 5 10 5s7.5 5 7.5 5-2.5 5-7.5 5-7.5-5-7.5-5zM10 8a2 2 0 1 0 0 4 2 2 0 0 0 0-4z',
  left: 'M12 5l-5 5 5 5',
  right: 'M8 5l5 5-5 5',
  up: 'M5 12l5-5 5 5',
  down: 'M5 8l5 5 5-5',
  trash: 'M4 6h12M8 6V4h4v2M5.5 6l.7 10h7.6l.7-10M8.5 9v4.5M11.5 9v4.5',
  link: 'M8.5 11.5a3 3 0 0 0 4.3 0l2.8-2.8a3 3 0 0 0-4.3-4.3l-.9.900M11.5 8.5a3 3 0 0 0-4.3 0l-2.8 2.8a3 3 0 0 0 4.3 4.3l.9-.9',
  bookmark: 'M6 3.5h8v13l-4-3.2-4 3.2z',
  keys: 'M10 3.5l5.5 6.5L10 16.5 4.5 10z',
  motion: 'M3 15c3.5 0 3.5-10 7-10s3.5 10 7 10',
  shape: 'M10 3l6 3.5v7L10 17l-6-3.5v-7zM4 6.5l6 3.5 6-3.5M10 10v7',
  chart: 'M3.5 3.5v13h13M6.5 13l3-4 2.5 2 4-5.5',
  reset: 'M4.5 4v4h4M4.8 8A6 6 0 1 1 4 11',
  check: 'M4.5 10.5l3.5 3.5 7.5-8',
  pin: 'M10 17v-5M6 12h8l-1.500-2.500V5h1V3h-7v2h1v4.500z',
  present: 'M3 4.5h14M4.5 4.5v8.5h11V4.5M10 13v2M6.5 17l3.5-2 3.5 2',
  qr: 'M3.5 3.5h5v5h-5zM11.5 3.5h5v5h-5zM3.5 11.5h5v5h-5zM11.5 11.5h2v2h-2zM16.5 11.5v2M14 16.5h2.5',
  enlarge: 'M11.5 3.5h5v5M16 4l-4.5 4.5M8.5 16.5h-5v-5M4 16l4.5-4.5',
  image: 'M3.5 4.5h13v11h-13zM3.5 13l3.5-3.5 3 3 2.5-2.5 4 4M12.5 7.5v.1',
} as const;

export type IconName = keyof typeof PATHS;

export function icon(name: IconName): SVGSVGElement {
  return svg(
    'svg',
    { viewBox: '0 0 20 20', class: `icon icon-${name}`, 'aria-hidden': 'true', focusable: 'false' },
    svg('path', { d: PATHS[name] }),
  );
}

/** Replaces the icon of a button made with `icon`. */
export function setIcon(holder: Element, name: IconName): void {
  const current = holder.querySelector('svg.icon');
  if (!current || current.classList.contains(`icon-${name}`)) return;
  current.replaceWith(icon(name));
}
