// Decides whether a step has to run again, by a stored digest of all its inputs.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { inRoot, root, stampsDir } from './paths.mjs';

/** All files below the given files and folders (relative to the repository), in a stable order. */
export function filesBelow(entries) {
  const found = [];
  const visit = (relative) => {
    const stats = statSync(inRoot(relative), { throwIfNoEntry: false });
    if (stats?.isFile()) found.push(relative);
    if (stats?.isDirectory())
      readdirSync(inRoot(relative))
        .sort()
        .forEach((name) => visit(path.join(relative, name)));
  };
  entries.forEach(visit);
  return found;
}

/** A digest of file and folder contents and of the given words. */
export function digest(entries, ...words) {
  const hash = createHash('sha256');
  for (const file of filesBelow(entries)) hash.update(`\0${file}\0`).update(readFileSync(path.join(root, file)));
  return hash.update(JSON.stringify(words)).digest('hex');
}

const stampFile = (name) => path.join(stampsDir, name);

/** True if the step last ended with this digest and its outputs still exist. */
export function isStamped(name, value, outputs) {
  if (!outputs.every((output) => existsSync(inRoot(output)))) return false;
  return existsSync(stampFile(name)) && readFileSync(stampFile(name), 'utf8') === value;
}

export function stamp(name, value) {
  mkdirSync(stampsDir, { recursive: true });
  writeFileSync(stampFile(name), value);
}
