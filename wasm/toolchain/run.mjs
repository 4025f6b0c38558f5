// The entry point of every npm script. Uses only Node, because it runs before any package is installed.
const [major] = process.versions.node.split('.').map(Number);
if (major < 20) {
  process.stderr.write(`shapespline needs Node 20 or newer, this is ${process.version}: https://nodejs.org\n`);
  process.exit(1);
}

const [name, ...args] = process.argv.slice(2);
const { commands } = await import('./commands.mjs');
const { Explained } = await import('./log.mjs');
try {
  if (!Object.hasOwn(commands, name)) throw new Explained(`usage: run.mjs ${Object.keys(commands).join('|')}`);
  await commands[name](args);
} catch (error) {
  if (!(error instanceof Explained)) throw error;
  process.stderr.write(`${error.message}\n`);
  process.exitCode = 1;
}
