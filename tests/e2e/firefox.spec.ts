/**
 * A smoke test in the system's Firefox ESR: the page starts, draws, moves, keeps its keys, and refuses a broken file.
 */
import { expect, test } from '@playwright/test';
import type { Page } from 'puppeteer-core';
import type {} from '../../web/app/test-hook.ts';
import { findFirefox, inFirefox } from './firefox.ts';

const program = findFirefox();

test('the page works in Firefox ESR', { tag: '@all' }, async ({}, info) => {
  test.skip(program === null, 'firefox-esr is not installed');
  test.skip(info.project.name === 'dev', 'the built page is what visitors get');
  test.setTimeout(240_000);
  await inFirefox(program!, async (page) => {
    await page.goto(info.project.use.baseURL!);
    if (!(await page.evaluate(() => document.createElement('canvas').getContext('webgl2') !== null))) {
      // Without a screen, Firefox has no WebGL in software: then the page must report that.
      expect(await page.$eval('[role=alert]', (alert) => alert.textContent)).toContain('WebGL 2');
      test.skip(true, 'this Firefox has no WebGL without a screen; install Xvfb');
    }
    const { moved, ...seen } = await motionIn(page);
    expect(seen).toEqual({ keys: 3, finite: true, inexact: 0, problem: false, refused: [] });
    expect(moved).toBeGreaterThan(0.01);
    expect(await colouredShare(page)).toBeGreaterThan(0.02);
    expect(await errorAfterOpening(page, 'bad.glb', '<!doctype html>')).toContain('bad.glb');
  });
});

/** The page's content and the motion of its shape; `inexact`: largest difference from the engine. */
async function motionIn(page: Page) {
  await page.waitForFunction(() => window.__shapespline !== undefined);
  return page.evaluate(async () => {
    const refused: string[] = [];
    document.addEventListener('securitypolicyviolation', (event) =>
      refused.push(`${event.violatedDirective} ${event.blockedURI}`),
    );
    const hook = window.__shapespline!;
    await hook.ready;
    await hook.settled();
    const at = async (t: number): Promise<number[]> => {
      await hook.setTime(t);
      return Array.from(hook.positions(0));
    };
    const largest = (a: number[], b: number[]): number =>
      a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i]!)), 0);
    const [start, middle, beyond] = [await at(0), await at(0.25), await at(1.3)];
    return {
      keys: hook.state.doc.keys.length,
      finite: [...start, ...middle, ...beyond].every(Number.isFinite),
      moved: Math.min(largest(start, middle), largest(middle, beyond)),
      inexact: largest(beyond, Array.from(await hook.evaluate(1.3))),
      problem: !document.querySelector<HTMLElement>('[data-testid=error]')!.hidden,
      refused,
    };
  });
}

/** Share of strongly coloured canvas pixels at a time between two keys. */
function colouredShare(page: Page): Promise<number> {
  return page.evaluate(async () => {
    await window.__shapespline!.setTime(0.25);
    const canvas = document.querySelector<HTMLCanvasElement>('.picture canvas')!;
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d')!;
    window.dispatchEvent(new Event('resize'));
    document.querySelector<HTMLElement>('[data-testid=floor]')!.click();
    await new Promise<void>((resolve) => {
      requestAnimationFrame(() => {
        copy.drawImage(canvas, 0, 0);
        resolve();
      });
    });
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    let coloured = 0;
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b] = [data[i]!, data[i + 1]!, data[i + 2]!];
      coloured += Math.max(r, g, b) - Math.min(r, g, b) > 40 ? 1 : 0;
    }
    return coloured / (data.length / 4);
  });
}

function errorAfterOpening(page: Page, name: string, content: string): Promise<string | null> {
  return page.evaluate(
    async (file, text) => {
      const input = document.querySelector<HTMLInputElement>('[data-testid=file-input]')!;
      const transfer = new DataTransfer();
      transfer.items.add(new File([text], file));
      input.files = transfer.files;
      input.dispatchEvent(new Event('change'));
      await window.__shapespline!.settled();
      return document.querySelector('[data-testid=error-message]')!.textContent;
    },
    name,
    content,
  );
}
