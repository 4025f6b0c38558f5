/** A separate program that loads a GLB with Babylon.js (NullEngine) and prints the time and memory. */
import { readFileSync } from 'node:fs';
import '@babylonjs/loaders/glTF/index.js';
import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js';
import { ImportMeshAsync } from '@babylonjs/core/Loading/sceneLoader.js';
import { Logger } from '@babylonjs/core/Misc/logger.js';
import { Scene } from '@babylonjs/core/scene.js';
import { MeshoptDecoder } from 'meshoptimizer';
import { ownPeak } from './process-memory.ts';

export interface Loaded {
  seconds: number;
  /** Growth of the process. */
  memoryMB: number;
  targets: number;
}

// Provides the decoder as in a worker, because Babylon.js would import it from its own server.
Object.assign(globalThis, {
  importScripts: () => {},
  MeshoptDecoder: { ...MeshoptDecoder, useWorkers: () => {} },
});

Logger.LogLevels = Logger.ErrorLogLevel;
const scene = new Scene(new NullEngine());
const before = process.memoryUsage().rss;
const bytes = new Uint8Array(readFileSync(process.argv[2]!));
const start = performance.now();
const { meshes } = await ImportMeshAsync(bytes, scene, { pluginExtension: '.glb' });
const loaded: Loaded = {
  seconds: (performance.now() - start) / 1000,
  memoryMB: ownPeak() - before / 2 ** 20,
  targets: Math.max(...meshes.map((mesh) => mesh.morphTargetManager?.numTargets ?? 0)),
};
process.stdout.write(`${JSON.stringify(loaded)}\n`);
process.exit(0);
