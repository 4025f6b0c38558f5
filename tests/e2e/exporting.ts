/** Helpers of export tests, from opening the dialog to the file. */
import { readFileSync } from 'node:fs';
import type { Download } from '@playwright/test';
import { expect } from './support.ts';
import type { App } from './support.ts';

export interface Exported {
  download: Download;
  bytes: Buffer;
  /** The dialog's description of the file, with plain spaces. */
  stated: string;
}

/** Opens the dialog and makes choices; resolves when the export's description is complete. */
export async function stated(app: App, choose: () => Promise<void>): Promise<string> {
  await app.by('export').click();
  await choose();
  await app.nextFrame();
  await expect(app.by('export-size')).not.toHaveText('Estimating the size');
  return plain(await app.by('export-size').innerText());
}

export async function exported(app: App, choose: () => Promise<void>): Promise<Exported> {
  const text = await stated(app, choose);
  // The button is pressed by key, because text above may move it away from the mouse.
  const [download] = await Promise.all([app.page.waitForEvent('download'), app.by('export-go').press('Enter')]);
  const bytes = readFileSync(await download.path());
  return { download, bytes, stated: text };
}

/** Types a value into a field of the dialog. */
export async function type(app: App, field: string, value: string): Promise<void> {
  await app.by(field).fill(value);
  await app.by(field).press('Enter');
}

/** The size in the dialog's description. */
export function statedBytes(text: string): number {
  const [, value, unit] = /about ([\d.]+) (B|kB|MB)/.exec(text)!;
  return Number(value) * { B: 1, kB: 1e3, MB: 1e6 }[unit as 'B' | 'kB' | 'MB'];
}

function plain(text: string): string {
  return text.replace(/\s+/g, ' ');
}
