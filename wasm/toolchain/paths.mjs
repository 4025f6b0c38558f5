// Folders of the build. Everything that the scripts download or generate is git-ignored and inside the repository.
import { fileURLToPath } from 'node:url';
import path from 'node:path';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
export const inRoot = (...parts) => path.join(root, ...parts);

export const toolchainDir = inRoot('.toolchain');
export const emscriptenDir = path.join(toolchainDir, 'emscripten');
export const headersDir = path.join(toolchainDir, 'headers');
export const buildDir = inRoot('build');
export const stampsDir = path.join(buildDir, 'stamps');
