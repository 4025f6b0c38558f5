import { createRoot } from 'react-dom/client';
import { Motion } from './react-component.tsx';

/** The component as shown on the page, with one file that has the whole motion. */
export function showReact(place: HTMLElement, motion: string): void {
  createRoot(place).render(<Motion poses={[motion]} boundary="natural" />);
}
