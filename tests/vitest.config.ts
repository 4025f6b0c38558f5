import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

const repository = fileURLToPath(new URL('..', import.meta.url));

// Three projects: `unit` needs no wasm, `engine` runs the built module in Node, `tools` hands what it makes to the
// programs that people use.
const project = (name: string, testTimeout: number) => ({
  extends: true as const,
  test: { name, include: [`tests/${name}/**/*.test.ts`], testTimeout },
});

export default defineConfig({
  root: repository,
  cacheDir: `${repository}build/vitest`,
  test: {
    environment: 'node',
    pool: 'forks',
    poolOptions: { forks: { maxForks: 2, minForks: 1 } },
    projects: [project('unit', 10_000), project('engine', 120_000), project('tools', 300_000)],
  },
});
