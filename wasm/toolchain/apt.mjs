// Installs Debian packages into the system, or unpacks them into a folder of the repository to keep the system's own
// versions.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { capture, run, which, withRetries } from './exec.mjs';
import { Explained, step } from './log.mjs';
import { toolchainDir } from './paths.mjs';

const quiet = { DEBIAN_FRONTEND: 'noninteractive', DEBCONF_NOWARNINGS: 'yes', LC_ALL: 'C.UTF-8' };
// Retries after network failures, and waits for another running apt.
const patience = ['-oAcquire::Retries=3', '-oDPkg::Lock::Timeout=600'];
// Older Emscripten packages of Debian fail with Node 18.
const emscriptenSuite = 'trixie';

function osRelease() {
  try {
    const lines = readFileSync('/etc/os-release', 'utf8').split('\n');
    return Object.fromEntries(lines.filter((l) => l.includes('=')).map((l) => l.replaceAll('"', '').split('=', 2)));
  } catch {
    return {};
  }
}

/** The reason why packages cannot be installed here, or null. */
export function whyNoInstall() {
  if (process.env.SHAPESPLINE_NO_INSTALL) return 'SHAPESPLINE_NO_INSTALL is set';
  const { ID, VERSION_ID } = osRelease();
  if (ID !== 'debian' || !['12', '13'].includes(VERSION_ID) || !which('apt-get')) {
    return 'packages are installed automatically on Debian 12 and 13 only';
  }
  if (process.getuid() !== 0) return 'installing Debian packages needs root';
  return null;
}

async function update(options, label) {
  step(`fetching the package lists${label}`);
  await withRetries('apt-get update', () =>
    run('apt-get', ['update', '-q', ...patience, '-oAcquire::Languages=none', ...options], { env: quiet }),
  );
}

/** Installs packages into the system. */
export async function installPackages(names) {
  // The first attempt fails if package lists are missing or out of date; then they are fetched.
  const install = () =>
    run('apt-get', ['install', '-y', '-q', '--no-install-recommends', ...patience, ...names], { env: quiet });
  const known = names.every((name) => capture('apt-cache', ['show', '--no-all-versions', name], { env: quiet }));
  if (!known) await update([], '');
  step(`installing ${names.join(' ')}`);
  try {
    await install();
  } catch {
    await update([], '');
    await withRetries('apt-get install', install);
  }
}

// The system's mirror, from its apt sources.
function mirror() {
  const { VERSION_CODENAME: codename } = osRelease();
  const format = '$(REPO_URI) $(RELEASE) $(COMPONENT)';
  const targets =
    capture('apt-get', ['indextargets', '--format', format, 'Created-By: Packages'], { env: quiet }) ?? '';
  const main = targets.split('\n').map((line) => line.split(' '));
  const found = main.find(([, suite, part]) => [codename, 'stable'].includes(suite) && part === 'main');
  if (!found) throw new Explained(`no source for Debian's ${codename} main archive among apt's sources`);
  return found[0];
}

// Apt options for isolated use: the newer release's lists, without the system's packages or hooks.
function separateWorld() {
  const folder = path.join(toolchainDir, 'apt');
  mkdirSync(path.join(folder, 'lists/partial'), { recursive: true });
  const keys = '/usr/share/keyrings/debian-archive-keyring.gpg';
  const signed = existsSync(keys) ? `[signed-by=${keys}] ` : '';
  writeFileSync(path.join(folder, 'sources.list'), `deb ${signed}${mirror()} ${emscriptenSuite} main\n`);
  writeFileSync(path.join(folder, 'status'), '');
  const lines = [
    `Dir::State::Lists "${folder}/lists";`,
    `Dir::State::status "${folder}/status";`,
    `Dir::Etc::SourceList "${folder}/sources.list";`,
    'Dir::Etc::SourceParts "/dev/null";',
    'Dir::Cache::pkgcache "";',
    'Dir::Cache::srcpkgcache "";',
    'APT::Sandbox::User "root";',
    // System hooks may clean caches that another apt is using.
    '#clear APT::Update::Pre-Invoke;',
    '#clear APT::Update::Post-Invoke;',
    '#clear APT::Update::Post-Invoke-Success;',
    '#clear Acquire::IndexTargets::deb::DEP-11;',
  ];
  writeFileSync(path.join(folder, 'apt.conf'), `${lines.join('\n')}\n`);
  return ['-c', path.join(folder, 'apt.conf')];
}

/** Archives listed by `apt-get download --print-uris`, as `{ file, sha256 }`. */
export function namedArchives(printed) {
  const lines = [...printed.matchAll(/^'[^']*' (\S+) \d+ SHA256:([0-9a-f]{64})$/gm)];
  return lines.map(([, file, sha256]) => ({ file, sha256 }));
}

/**
 * Fails if an archive in `folder` does not match the signed package lists. Bad archives are deleted and fetched again.
 */
export function verifyArchives(folder, archives) {
  for (const { file, sha256 } of archives) {
    const full = path.join(folder, file);
    if (existsSync(full) && createHash('sha256').update(readFileSync(full)).digest('hex') === sha256) continue;
    rmSync(full, { force: true });
    throw new Explained(`${file} was not downloaded whole, or is not what the package lists promise; run this again`);
  }
}

/** Downloads packages of the newer release and unpacks them into `folder`, which appears only when complete. */
export async function unpackPackages(names, folder, finish = () => {}) {
  const options = separateWorld();
  const partial = `${folder}.partial`;
  const archives = path.join(toolchainDir, 'archives');
  rmSync(partial, { recursive: true, force: true });
  mkdirSync(partial, { recursive: true });
  mkdirSync(archives, { recursive: true });
  await update(options, ` of Debian ${emscriptenSuite}`);
  const download = [...options, ...patience, '-q', 'download'];
  const named = namedArchives(capture('apt-get', [...download, '--print-uris', ...names], { env: quiet }) ?? '');
  if (named.length < names.length)
    throw new Explained(`Debian ${emscriptenSuite} does not list all of ${names.join(' ')}`);
  step(`downloading ${names.join(' ')} from Debian ${emscriptenSuite}`);
  await withRetries('apt-get download', async () => {
    await run('apt-get', [...download, ...names], { cwd: archives, env: quiet });
    verifyArchives(archives, named);
  });
  for (const { file } of named) {
    step(`unpacking ${file.split('_', 2).join(' ')}`);
    await run('dpkg', ['-x', path.join(archives, file), partial]);
  }
  await finish(partial);
  rmSync(folder, { recursive: true, force: true });
  renameSync(partial, folder);
  rmSync(archives, { recursive: true, force: true });
}
