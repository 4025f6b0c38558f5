/** The page's entrance. */
import { startApp } from './app.ts';

// Marks of the start: scripts, files read, motion made, first shape on the screen (npm run bench -- start).
performance.mark('shapespline scripts');
const root = document.getElementById('app');
if (root) start(root);

function start(element: HTMLElement): void {
  try {
    startApp(element);
  } catch (error) {
    // Before there are components nothing else can say it.
    const message = document.createElement('p');
    message.setAttribute('role', 'alert');
    message.textContent = `This page needs WebGL 2, which is not available in this browser. Try another browser, or turn hardware acceleration on. (${error instanceof Error ? error.message : String(error)})`;
    message.style.cssText = 'max-width: 60ch; margin: 20vh auto; padding: 0 24px';
    element.replaceChildren(message);
  }
}
