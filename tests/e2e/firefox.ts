/** The system's Firefox, controlled by WebDriver BiDi. */
import { spawn } from 'node:child_process';
import { accessSync, constants } from 'node:fs';
import path from 'node:path';
import puppeteer from 'puppeteer-core';
import type { Page } from 'puppeteer-core';

const PREFERENCES = {
  // WebGL without a graphics card.
  'webgl.force-enabled': true,
  'webgl.forbid-software': false,
  'webgl.out-of-process': false,
  'ui.prefersReducedMotion': 1,
};

/** Path of the system's Firefox ESR, or null. */
export function findFirefox(): string | null {
  return find('firefox-esr');
}

function find(program: string): string | null {
  const found = (process.env['PATH'] ?? '')
    .split(path.delimiter)
    .map((folder) => path.join(folder, program))
    .find((file) => {
      try {
        accessSync(file, constants.X_OK);
        return true;
      } catch {
        return false;
      }
    });
  return found ?? null;
}

interface Display {
  name: string;
  stop(): void;
}

/** A virtual screen, if Xvfb is installed: without a screen, Firefox has no WebGL in software. */
async function startDisplay(): Promise<Display | null> {
  const program = find('Xvfb');
  if (!program) return null;
  const server = spawn(program, ['-displayfd', '3', '-screen', '0', '1280x900x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  });
  const number = await new Promise<string | null>((resolve) => {
    server.stdio[3]?.once('data', (data: Buffer) => resolve(data.toString().trim()));
    server.once('error', () => resolve(null));
    server.once('exit', () => resolve(null));
  });
  return number === null ? null : { name: `:${number}`, stop: () => server.kill() };
}

/** Runs `use` in a page of a new profile and always ends the browser. */
export async function inFirefox(program: string, use: (page: Page) => Promise<void>): Promise<void> {
  const display = await startDisplay();
  try {
    const browser = await puppeteer.launch({
      browser: 'firefox',
      executablePath: program,
      headless: display === null,
      extraPrefsFirefox: PREFERENCES,
      env: { ...process.env, LIBGL_ALWAYS_SOFTWARE: '1', ...(display ? { DISPLAY: display.name } : {}) },
      defaultViewport: null,
      timeout: 60_000,
      protocolTimeout: 120_000,
    });
    try {
      const page = await browser.newPage();
      page.setDefaultTimeout(120_000);
      await use(page);
    } finally {
      await browser.close();
    }
  } finally {
    display?.stop();
  }
}
