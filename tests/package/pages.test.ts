/** The package on pages without a bundler: on their own host, on another host, under a strict policy. */
import { copyFileSync, rmSync } from 'node:fs';
import path from 'node:path';
import { beforeAll, expect, it } from 'vitest';
import { askedElsewhere, host, outcomeOf } from './support/browser.ts';
import { sumInNode } from './support/expected.ts';
import { newProject, type Outcome, packageIn, script } from './support/project.ts';

/** Headers of a host whose files any page may import. */
const CORS = { 'access-control-allow-origin': '*', 'cross-origin-resource-policy': 'cross-origin' };

let project: string;
let expected: Outcome;
beforeAll(async () => {
  project = await newProject();
  expected = await sumInNode(project);
});

/** Node's numbers, to single precision. */
function expectSame(outcome: Outcome): void {
  expect(outcome.error).toBeUndefined();
  expect(outcome.vertices).toBe(expected.vertices);
  expect(outcome.sum! / expected.sum!).toBeCloseTo(1, 6);
}

/** A project page on one host, the package on another. */
async function acrossHosts({ policy = '', first = '' } = {}): Promise<string> {
  const library = await host([packageIn(project)], { name: '127.0.0.1', headers: CORS });
  const folder = await newProject({ 'main.js': script(`${library}index.js`, first) });
  copyFileSync(path.join(packageIn(project), 'worker.js'), path.join(folder, 'own-worker.js'));
  rmSync(path.join(folder, 'node_modules'), { recursive: true });
  const headers: Record<string, string> = {};
  if (policy) headers['content-security-policy'] = policy.replaceAll('LIBRARY', new URL(library).origin);
  return host([folder, path.join(folder, 'public')], { headers });
}

/** wasm-unsafe-eval allows only compiling WebAssembly. */
const STRICT =
  "default-src 'none'; script-src 'self' LIBRARY 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob:; " +
  "connect-src 'self' LIBRARY; ";

it('runs on a plain page that serves the package itself', async () => {
  const folder = await newProject({ 'main.js': script('./node_modules/shapespline/index.js') });
  expectSame(await outcomeOf(await host([folder, path.join(folder, 'public')])));
});

it('runs on a page with an import map', async () => {
  const map = '{ "imports": { "shapespline": "./node_modules/shapespline/index.js" } }';
  const folder = await newProject({
    'index.html': `<!doctype html><script type="importmap">${map}</script><script type="module" src="main.js"></script>`,
  });
  expectSame(await outcomeOf(await host([folder, path.join(folder, 'public')])));
});

it('runs from another host', async () => {
  expectSame(await outcomeOf(await acrossHosts()));
});

it('runs from another host under a strict policy', async () => {
  expectSame(await outcomeOf(await acrossHosts({ policy: `${STRICT}worker-src blob: LIBRARY` })));
});

it('runs under a policy that refuses blob: URLs, with the worker on the host of the page', async () => {
  const first = "configure({ workerUrl: './own-worker.js' });";
  expectSame(await outcomeOf(await acrossHosts({ policy: `${STRICT}worker-src 'self'`, first })));
});

it('reports what to do if the policy allows no worker', async () => {
  const { error } = await outcomeOf(await acrossHosts({ policy: `${STRICT}worker-src 'self'` }));
  expect(error).toMatch(
    /^EngineError: The worker did not start from http:.*worker\.js, .*configure\(\{ workerUrl \}\)/,
  );
});

it('reports what to do if the server returns a web page instead of WebAssembly', async () => {
  const folder = await newProject({
    'main.js': script('./node_modules/shapespline/index.js', "configure({ wasmUrl: '/gone.wasm' });"),
  });
  const url = await host([folder, path.join(folder, 'public')], { spare: '<!doctype html><title>Home</title>' });
  const { error } = await outcomeOf(url);
  expect(error).toContain(`${url}gone.wasm returned “<!doctype html>`);
  expect(error).toMatch(/Put the \.wasm file there, or set its URL: configure/);
});

it('large shapes use the module for two threads on an isolated page, also from another host', async () => {
  const isolated = { 'cross-origin-opener-policy': 'same-origin', 'cross-origin-embedder-policy': 'require-corp' };
  const library = await host([packageIn(project)], { name: '127.0.0.1', headers: CORS });
  const folder = await newProject({
    'main.js': `
      import { createEngine } from '${library}index.js';
      const side = 210; // 44,100 vertices: above what threads are tried for
      const vertices = Array.from({ length: side * side }, (_, i) => [i % side, Math.floor(i / side)]);
      const corner = (x, y) => y * side + x + 1;
      const squares = vertices.filter(([x, y]) => x < side - 1 && y < side - 1);
      const faces = squares.map(
        ([x, y]) => \`f \${corner(x, y)} \${corner(x + 1, y)} \${corner(x + 1, y + 1)}\\n\` +
          \`f \${corner(x, y)} \${corner(x + 1, y + 1)} \${corner(x, y + 1)}\`);
      const pose = (bend) => vertices.map(([x, y]) => \`v \${x} \${y} \${bend * Math.sin(x / 40)}\`);
      const file = (bend) => ({ name: bend + '.obj', bytes: new TextEncoder().encode([...pose(bend), ...faces].join('\\n')) });
      try {
        const engine = createEngine();
        const sequence = await engine.createSequence(await engine.importKeyframes([file(1), file(9)]));
        const started = performance.getEntriesByType('resource').some(({ name }) => name.endsWith('threads.wasm'));
        const frame = await sequence.evaluate(0.5);
        window.outcome = { isolated: crossOriginIsolated, started, vertices: frame.positions.length / 3 };
      } catch (error) {
        window.outcome = { error: String(error) };
      }
    `,
  });
  rmSync(path.join(folder, 'node_modules'), { recursive: true });
  const outcome = await outcomeOf(await host([folder], { headers: isolated }));
  expect(outcome).toEqual({ isolated: true, started: true, vertices: 44_100 });
});

it('a request to another host is detected', async () => {
  const folder = await newProject({
    'main.js': "await fetch('http://elsewhere.test/x').catch(() => 0); window.outcome = 1",
  });
  await expect(outcomeOf(await host([folder]))).rejects.toThrow('elsewhere.test');
  expect(askedElsewhere()).toEqual([]);
});
