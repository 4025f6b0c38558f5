/** Drives the Firefox of the system by its own protocol, Marionette: commands as JSON over TCP, each with its length before it. */
import { spawn } from 'node:child_process';
import type { ChildProcess } from 'node:child_process';
import { accessSync, constants, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import type { Socket } from 'node:net';
import { tmpdir } from 'node:os';
import path from 'node:path';

const START_MS = 60_000;

const PREFERENCES = [
  ['marionette.port', 0],
  ['app.update.enabled', false],
  ['datareporting.policy.dataSubmissionEnabled', false],
  ['browser.shell.checkDefaultBrowser', false],
  ['browser.startup.homepage_override.mstone', 'ignore'],
  ['toolkit.telemetry.enabled', false],
  ['network.captive-portal-service.enabled', false],
  ['network.connectivity-service.enabled', false],
  ['app.normandy.enabled', false],
  // WebGL without a graphics card.
  ['webgl.force-enabled', true],
  ['webgl.forbid-software', false],
  ['webgl.out-of-process', false],
  ['ui.prefersReducedMotion', 1],
] as const;

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

/** A screen that nobody sees, where Xvfb is installed: without any screen Firefox has no WebGL in software. */
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

export class Firefox {
  private buffer = Buffer.alloc(0);
  private readonly waiting = new Map<number, { resolve(value: unknown): void; reject(error: Error): void }>();
  private lastId = 0;

  private constructor(
    private readonly browser: ChildProcess,
    private readonly socket: Socket,
    private readonly profile: string,
    private readonly display: Display | null,
  ) {
    socket.on('data', (chunk) => this.receive(chunk));
    socket.on('error', (error) => this.fail(error));
    socket.on('close', () => this.fail(new Error('Firefox has closed the connection.')));
  }

  static async start(program: string): Promise<Firefox> {
    const profile = mkdtempSync(path.join(tmpdir(), 'shapespline-firefox-'));
    writeFileSync(
      path.join(profile, 'user.js'),
      PREFERENCES.map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});\n`).join(''),
    );
    const display = await startDisplay();
    const browser = spawn(
      program,
      [...(display ? [] : ['--headless']), '--no-remote', '--marionette', '--profile', profile],
      {
        stdio: 'ignore',
        env: {
          ...process.env,
          HOME: profile,
          MOZ_CRASHREPORTER_DISABLE: '1',
          LIBGL_ALWAYS_SOFTWARE: '1',
          ...(display ? { DISPLAY: display.name } : {}),
        },
      },
    );
    try {
      const port = await portOf(profile, browser);
      const socket = connect(port, '127.0.0.1');
      const firefox = new Firefox(browser, socket, profile, display);
      await firefox.command('WebDriver:NewSession', { capabilities: { alwaysMatch: { pageLoadStrategy: 'normal' } } });
      await firefox.command('WebDriver:SetTimeouts', { script: 120_000, pageLoad: 120_000 });
      return firefox;
    } catch (error) {
      browser.kill('SIGKILL');
      display?.stop();
      rmSync(profile, { recursive: true, force: true });
      throw error;
    }
  }

  async open(url: string): Promise<void> {
    await this.command('WebDriver:Navigate', { url });
  }

  /** Runs the body of an async function in the page; its value must be JSON. */
  async run<T>(body: string, ...args: unknown[]): Promise<T> {
    const script = `const done = arguments[arguments.length - 1]; const args = Array.from(arguments).slice(0, -1);
      (async (...args) => { ${body} })(...args).then((value) => done({ value }), (error) => done({ error: String(error) }));`;
    const { value } = (await this.command('WebDriver:ExecuteAsyncScript', {
      script,
      args,
      newSandbox: false,
      sandbox: null,
    })) as { value: { value?: T; error?: string } };
    if (value.error) throw new Error(value.error);
    return value.value as T;
  }

  async stop(): Promise<void> {
    const ended = new Promise((resolve) => this.browser.once('exit', resolve));
    this.socket.destroy();
    this.browser.kill();
    await Promise.race([ended, new Promise((resolve) => setTimeout(resolve, 5000))]);
    this.browser.kill('SIGKILL');
    this.display?.stop();
    rmSync(this.profile, { recursive: true, force: true });
  }

  private command(name: string, parameters: object): Promise<unknown> {
    this.lastId += 1;
    const text = JSON.stringify([0, this.lastId, name, parameters]);
    return new Promise((resolve, reject) => {
      this.waiting.set(this.lastId, { resolve, reject });
      this.socket.write(`${Buffer.byteLength(text)}:${text}`);
    });
  }

  private receive(chunk: Buffer): void {
    this.buffer = Buffer.concat([this.buffer, chunk]);
    for (;;) {
      const colon = this.buffer.indexOf(':');
      if (colon < 0) return;
      const end = colon + 1 + Number(this.buffer.subarray(0, colon).toString());
      if (this.buffer.length < end) return;
      const message: unknown = JSON.parse(this.buffer.subarray(colon + 1, end).toString());
      this.buffer = this.buffer.subarray(end);
      if (Array.isArray(message)) this.answer(message as [number, number, { message?: string } | null, unknown]);
    }
  }

  private answer([, id, error, result]: [number, number, { message?: string } | null, unknown]): void {
    const call = this.waiting.get(id);
    this.waiting.delete(id);
    if (error) call?.reject(new Error(error.message ?? 'Firefox refused a command.'));
    else call?.resolve(result);
  }

  private fail(error: Error): void {
    for (const { reject } of this.waiting.values()) reject(error);
    this.waiting.clear();
  }
}

/** Firefox writes the port that it has chosen into its profile. */
async function portOf(profile: string, browser: ChildProcess): Promise<number> {
  const file = path.join(profile, 'MarionetteActivePort');
  for (const end = Date.now() + START_MS; Date.now() < end; ) {
    const port = existsSync(file) ? Number(readFileSync(file, 'utf8')) : 0;
    if (port > 0) return port;
    if (browser.exitCode !== null) throw new Error(`Firefox ended with code ${browser.exitCode}.`);
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
  throw new Error('Firefox did not open its port.');
}
