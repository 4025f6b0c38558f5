// The browser for the end-to-end tests.
import { existsSync, readdirSync } from 'node:fs';
import { homedir } from 'node:os';
import path from 'node:path';
import { whyNoInstall } from './apt.mjs';
import { which } from './exec.mjs';

/** The headless shell has no windows, which saves a tenth of a test's time. */
const HEADLESS = 'chromium-headless-shell';
const names = [HEADLESS, 'chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];

/** Playwright's own browser if downloaded, else the system's; null if there is neither. */
export function findBrowser(chromium) {
  return existsSync(chromium.executablePath()) ? chromium.executablePath() : findSystemBrowser();
}

function findSystemBrowser() {
  return names.map((name) => which(name)).find(Boolean) ?? null;
}

/**
 * Whether a browser is available; checked before Playwright is installed. If packages can be installed, requires the
 * browser for tests.
 */
export function hasBrowser() {
  const downloads = process.env.PLAYWRIGHT_BROWSERS_PATH ?? path.join(homedir(), '.cache/ms-playwright');
  const downloaded = existsSync(downloads) && readdirSync(downloads).some((name) => name.startsWith('chromium'));
  return downloaded || (whyNoInstall() ? findSystemBrowser() !== null : which(HEADLESS) !== null);
}
