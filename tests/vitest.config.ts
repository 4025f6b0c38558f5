import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

const repository = fileURLToPath(new URL('..', import.meta.url));

// `unit` needs no wasm, `engine` runs the built module in Node, `tools` opens our files in common programs, and
// `package` tests the tarball like a page author.
// Tests marked `@all` run with SHAPESPLINE_ALL=1 only, as in `e2e`.
const testNamePattern = process.env.SHAPESPLINE_ALL === '1' ? undefined : /^(?!.*@all)/;
const project = (name: string, testTimeout: number, more: { globalSetup?: string } = {}) => ({
  extends: true as const,
  // Preparation before tests, such as starting a browser, may take as long as a test.
  test: {
    name,
    include: [`tests/${name}/**/*.test.ts`],
    testNamePattern,
    testTimeout,
    hookTimeout: testTimeout,
    ...more,
  },
});

export default defineConfig({
  root: repository,
  cacheDir: `${repository}build/vitest`,
  test: {
    environment: 'node',
    pool: 'forks',
    poolOptions: { forks: { maxForks: 2, minForks: 1 } },
    projects: [
      // A few unit tests read the whole repository, which takes long beside other processes.
      project('unit', 30_000),
      project('engine', 120_000),
      project('tools', 300_000),
      project('package', 240_000, { globalSetup: 'tests/package/support/setup.ts' }),
    ],
  },
});
