/**
 * npm run bench -- ghost [FACES[:KEYS],...]: costs and benefits of a ghost mesh. Without sizes, error and time over
 * ghost sizes as in the paper's Fig. 8 (the cactus sample and a generated mesh), then one ghost of 2,000 faces for
 * large meshes.
 */
import { execFileSync } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Wanted } from '../../wasm/toolchain/bench-arguments.mjs';
import type { Engine, Keys } from '../../web/engine/api/api.ts';
import { msText, studyGhosts, studyTimes, verdictOf, type GhostStudy } from '../../web/study/ghost-study.ts';
import { createEngine } from '../../web/engine/node.ts';
import type { ImportOptions } from '../../web/engine/api/types.ts';

const DEFAULT_MESHES = [
  { faces: 85_000, keys: 10 },
  { faces: 330_000, keys: 3 },
];
const USUAL_KEYS = 3;
const FRAMES = 24;
const GHOST_FACES = 2000;
/** Larger meshes get one ghost instead of all sizes. */
const STUDIED_FACES = 100_000;
const cactus = fileURLToPath(new URL('../../public/samples/cactus.glb', import.meta.url));
const generator = fileURLToPath(new URL('../cmake-wasm/shapespline_meshes.js', import.meta.url));

type Line = string[];

export async function benchGhost({ sizes }: Wanted): Promise<void> {
  if (!sizes) await bench('cactus', cactus);
  const folder = await mkdtemp(path.join(tmpdir(), 'shapespline-bench-'));
  try {
    for (const { faces, keys } of sizes ?? DEFAULT_MESHES) {
      execFileSync(process.execPath, [generator, '--bench', String(faces), String(keys ?? USUAL_KEYS), folder], {
        stdio: ['ignore', 'ignore', 'inherit'],
      });
      await bench(`generated, ${faces} faces`, path.join(folder, `bench-${faces}.glb`), { sample: keys ?? USUAL_KEYS });
    }
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

async function bench(name: string, file: string, options: ImportOptions = {}): Promise<void> {
  const engine = createEngine();
  try {
    const start = performance.now();
    const keys = await engine.importKeyframes(
      [{ name: path.basename(file), bytes: new Uint8Array(await readFile(file)) }],
      options,
    );
    const importMs = performance.now() - start;
    const { vertices, faces } = keys.info.report;
    console.log(
      `\n${name}: ${vertices} vertices, ${faces} faces, ${keys.info.times.length} keys; import ${msText(importMs)}\n`,
    );
    if (faces <= STUDIED_FACES) await study(engine, keys);
    await large(engine, keys);
  } finally {
    engine.dispose();
  }
}

async function study(engine: Engine, keys: Keys): Promise<void> {
  const { times } = keys.info;
  const result = await studyGhosts(engine, keys, {}, { times: studyTimes(times[0]!, times.at(-1)!) });
  print(
    [
      'ghost',
      'transfer',
      'KG %',
      'frame ms',
      'simplify ms',
      'encode ms',
      'transfer ms',
      'order + factor ms',
      'build ms',
    ],
    linesOf(result),
  );
  console.log(`\n${verdictOf(result)}\n`);
}

function linesOf({ rows, ms, buildMs }: GhostStudy): Line[] {
  const lines = rows.map(({ faces, transfer, kg, ms: frame, buildMs: build, stats: s }) => [
    String(faces),
    transfer,
    kg.toFixed(3),
    frame.toFixed(2),
    s.simplifyMs.toFixed(0),
    s.encodeMs.toFixed(0),
    s.transferMs.toFixed(0),
    (s.orderMs + s.factorMs + s.arrangeMs).toFixed(0),
    build.toFixed(0),
  ]);
  return [...lines, ['none', '-', '0', ms.toFixed(2), '-', '-', '-', '-', buildMs.toFixed(0)]];
}

/** Every stage of one ghost, the longest time between two progress reports, and the heap. */
async function large(engine: Engine, keys: Keys): Promise<void> {
  const lines: Line[] = [];
  for (const ghostFaces of [GHOST_FACES, 0]) {
    const start = performance.now();
    let last = start;
    let silence = { ms: 0, stage: '' };
    const sequence = await engine.createSequence(
      keys,
      { ghostFaces },
      {
        onProgress: ({ stage }) => {
          const now = performance.now();
          if (now - last > silence.ms) silence = { ms: now - last, stage };
          last = now;
        },
      },
    );
    const buildMs = performance.now() - start;
    const [first, end] = sequence.range;
    const ms: number[] = [];
    for (let i = 0; i < FRAMES; i += 1) {
      const asked = performance.now();
      const frame = await sequence.evaluate(first + ((i + 0.5) / FRAMES) * (end - first));
      ms.push(performance.now() - asked);
      frame!.release();
    }
    ms.sort((a, b) => a - b);
    const s = await sequence.stats();
    lines.push([
      ghostFaces > 0 ? String(s.ghostFaces) : 'none',
      ...[s.weldMs, s.simplifyMs, s.encodeMs, s.transferMs, s.orderMs, s.factorMs, buildMs].map((value) =>
        value.toFixed(0),
      ),
      ms[FRAMES / 2]!.toFixed(1),
      ms.at(-1)!.toFixed(1),
      `${silence.ms.toFixed(0)} (${silence.stage})`,
      (s.heapBytes / 2 ** 20).toFixed(0),
    ]);
    sequence.dispose();
  }
  print(
    [
      'ghost',
      'weld',
      'simplify',
      'encode',
      'transfer',
      'order',
      'factor',
      'build ms',
      'response ms',
      'slowest',
      'longest silence ms',
      'heap MB',
    ],
    lines,
  );
}

function print(titles: Line, lines: Line[]): void {
  const widths = titles.map((title, column) => Math.max(title.length, ...lines.map((line) => line[column]!.length)));
  for (const line of [titles, ...lines])
    console.log(line.map((cell, column) => cell.padStart(widths[column]!)).join('  '));
}
