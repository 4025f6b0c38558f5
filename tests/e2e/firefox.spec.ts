/** A smoke test in the system's Firefox ESR: the page starts, draws, moves, keeps its keys, refuses a broken file. */
import { expect, test } from '@playwright/test';
import { Firefox, findFirefox } from './marionette.ts';

const program = findFirefox();

test('the page works in Firefox ESR', async ({}, info) => {
  test.skip(program === null, 'firefox-esr is not installed');
  test.skip(info.project.name === 'dev', 'the built page is what visitors get');
  test.setTimeout(240_000);
  const firefox = await Firefox.start(program!);
  try {
    await firefox.open(info.project.use.baseURL!);
    const hasWebGl = await firefox.run<boolean>(
      `return document.createElement('canvas').getContext('webgl2') !== null;`,
    );
    if (!hasWebGl) {
      // Without a screen there is none in software: then the page must say so, and that is all there is to see.
      const alert = await firefox.run<string>(`return document.querySelector('[role=alert]').textContent;`);
      expect(alert).toContain('WebGL 2');
      test.skip(true, 'this Firefox has no WebGL without a screen; install Xvfb');
    }
    const seen = await firefox.run<{
      keys: number;
      finite: boolean;
      moved: number;
      exact: number;
      problem: boolean;
      policy: string[];
    }>(`
      const refused = [];
      document.addEventListener('securitypolicyviolation', (event) => refused.push(event.violatedDirective + ' ' + event.blockedURI));
      while (!window.__shapespline) await new Promise((resolve) => setTimeout(resolve, 50));
      const hook = window.__shapespline;
      await hook.ready;
      await hook.settled();
      const at = async (t) => { await hook.setTime(t); return hook.positions(0); };
      const largest = (a, b) => a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i])), 0);
      const [start, middle, beyond] = [await at(0), await at(0.25), await at(1.3)];
      const engine = await hook.evaluate(1.3);
      return {
        keys: hook.state.doc.keys.length, finite: [...start, ...middle, ...beyond].every(Number.isFinite),
        moved: Math.min(largest(start, middle), largest(middle, beyond)), exact: largest(beyond, engine),
        problem: !document.querySelector('[data-testid=error]').hidden, policy: refused,
      };`);
    expect(seen).toMatchObject({ keys: 3, finite: true, exact: 0, problem: false, policy: [] });
    expect(seen.moved).toBeGreaterThan(0.01);
    const pixels = await firefox.run<number>(`
      const hook = window.__shapespline;
      await hook.setTime(0.25);
      const canvas = document.querySelector('.picture canvas');
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
      window.dispatchEvent(new Event('resize'));
      document.querySelector('[data-testid=floor]').click();
      await new Promise((resolve) => requestAnimationFrame(() => { copy.drawImage(canvas, 0, 0); resolve(); }));
      const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
      let coloured = 0;
      for (let i = 0; i < data.length; i += 4) coloured += Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > 40;
      return coloured / (data.length / 4);`);
    expect(pixels).toBeGreaterThan(0.02);
    const sentence = await firefox.run<string>(`
      const input = document.querySelector('[data-testid=file-input]');
      const transfer = new DataTransfer();
      transfer.items.add(new File(['<!doctype html>'], 'bad.glb'));
      input.files = transfer.files;
      input.dispatchEvent(new Event('change'));
      await window.__shapespline.settled();
      return document.querySelector('[data-testid=error-message]').textContent;`);
    expect(sentence).toContain('bad.glb');
  } finally {
    await firefox.stop();
  }
});
