/** The page's entry point. The engine starts while the larger app is still loading. */
import { createEngine } from '../engine/index.ts';
import type { StartedEngine } from './session/session.ts';

const root = document.getElementById('app');
if (root) void start(root);

async function start(element: HTMLElement): Promise<void> {
  try {
    const started: StartedEngine = {
      engine: createEngine({ onLost: () => started.onLost() }),
      onLost: () => undefined,
    };
    const { startApp } = await import('./app.ts');
    // Performance marks of the start: scripts, files read, motion made, first shape on the screen (npm run bench --
    // start).
    performance.mark('shapespline scripts');
    startApp(element, started);
  } catch (error) {
    // No component exists yet to show the error.
    element.replaceChildren(notStarted(error instanceof Error ? error.message : String(error)));
  }
}

function notStarted(reason: string): HTMLElement {
  const message = document.createElement('p');
  message.textContent = /webgl/i.test(reason)
    ? `This page needs WebGL 2, which is not available in this browser. Try another browser, or turn hardware acceleration on. (${reason})`
    : `This page could not start. Check the connection and try again. (${reason})`;
  const retry = document.createElement('button');
  retry.className = 'button plain';
  retry.textContent = 'Try again';
  retry.onclick = () => location.reload();
  const box = document.createElement('div');
  box.setAttribute('role', 'alert');
  box.style.cssText =
    'max-width: 60ch; margin: 20vh auto; padding: 0 24px; display: grid; gap: 16px; justify-items: start';
  box.append(message, retry);
  return box;
}
