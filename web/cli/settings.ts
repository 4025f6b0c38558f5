/** The options of the commands: one table says which there are, what they mean, and how their text is read. */
import type { ExportOptions, ImportOptions, SequenceOptions } from '../engine/api/types.ts';
import { UsageError, type Arguments, type Known } from './arguments.ts';
import * as read from './values.ts';

const IMPORT = ['key-times', 'animation', 'sample', 'up', 'unit'];
const MOTION = [
  'boundary', 'start-speed', 'end-speed', 'start-tangent', 'end-tangent', 'period', 'tension', 'bias', 'method', 'stretch', 'precision',
  'patches', 'reference', 'turns', 'ghost-faces', 'transfer', 'placement',
];
const EXPORT = ['output', 'report', 'at', 'frames', 'range', 'duration'];

export const INSPECT: Known = { options: new Set(IMPORT), flags: new Set(['help']) };
export const COMPLETE: Known = { options: new Set([...IMPORT, ...MOTION, ...EXPORT]), flags: new Set(['in-place', 'help']) };

export const HELP = `shapespline: smooth motion of a shape through key poses

  inspect FILE...                        what the files hold, as JSON on stdout
  complete FILE... --output OUT          the completed motion

FILE is a .glb, .gltf, .obj, .ply or .off file: several are the keys in the order given, one holds
morph targets or an animation. What a .gltf or .obj names (buffers, materials, textures) is read from
its own folder.
OUT ending in .glb is one file with an animation, in .obj or .ply one shape (with one --at time), and
a folder (ending in /) gets 0000.obj, 0001.obj, ... one for each requested time.

Keys are counted from 1, animations from 0, and everything in a report from 0. Times are in any unit you like.

  --report R.json                        options, timings, counts, warnings, volume and area
  --key-times T,T,...                    default: evenly over [0,1], or the animation's own times
  --animation NAME|INDEX                 take the keys from this animation of the one file
  --sample T,T,... | N                   at these seconds of it, or N evenly spaced (default 8)
  --up y|z  --unit METRES                of .obj, .ply and .off files

  --method lri|geodesic|linear|cubic-vertex
  --boundary natural|hermite|periodic
  --start-speed S  --end-speed S         hermite: times the keys' own speed at that end; 0 eases
  --start-tangent FILE  --end-tangent FILE   hermite: a shape that the motion comes from or goes to
  --period P                             periodic: length of one whole period
  --tension X,X,...                      for each key: 0 as it is, 1 stops there
  --bias X,X,...                         for each key, from -1 to 1: below 0 its slope leans towards that to the key
                                         after it, above 0 towards that from the key before
  --turns KEY:N[@COMPONENT],...          whole turns added on the way to a key: of the whole, or of one of
                                         its separate parts, counted from 1 as their faces come in the file
  --stretch linear|log                   how stretch is interpolated; log never turns inside out
  --reference KEY                        key that the others are measured against
  --patches N                            default: about the square root of the number of faces
  --precision single|double|exact        exact: as accurate as double, in less memory
  --ghost-faces N|off                    let a coarse mesh of N faces lead the shape; default off
  --transfer exact|paper                 with it: through every key (default), or as published
  --placement vertices|optimal           of the coarse mesh; default: on vertices of the shape
  --in-place                             without the motion of the whole

  --at T,T,...                           these times
  --frames K --range A:B                 or K evenly spaced ones; default: 60 over the keys
                                         (both may lie beyond the keys: --at=-0.3,1.3)
  --duration SECONDS                     of the exported animation; its times start at 0 and
                                         include the keys in range

  --help  --version
Exit codes: 0 done, 1 the input is bad, 2 wrong use.
`;

/** Reads one option, or leaves the default. */
function value<T>(args: Arguments, name: string, reader: (text: string, option: string) => T): T | undefined {
  const text = args.values.get(name);
  return text === undefined ? undefined : reader(text, `--${name}`);
}

/** Without the entries that were not given, so that the engine's defaults hold. */
function given<T extends object>(entries: { [K in keyof T]: T[K] | undefined }): Partial<T> {
  return Object.fromEntries(Object.entries(entries).filter(([, v]) => v !== undefined)) as Partial<T>;
}

export function importOptions(args: Arguments): ImportOptions {
  const sample = (text: string, option: string): number[] | number =>
    /^\d+$/.test(text) ? read.wholeFrom(2)(text, option) : read.times(text, option);
  return given<ImportOptions>({
    keyTimes: value(args, 'key-times', read.numbers),
    animation: value(args, 'animation', read.animation),
    sample: value(args, 'sample', sample),
    up: value(args, 'up', read.oneOf('y', 'z')),
    unit: value(args, 'unit', read.positive),
  });
}

/** All but the tangents, which are files. */
export function sequenceOptions(args: Arguments): Partial<SequenceOptions> {
  return given<SequenceOptions>({
    method: value(args, 'method', read.oneOf('lri', 'geodesic', 'linear', 'cubic-vertex')),
    boundary: value(args, 'boundary', read.oneOf('natural', 'hermite', 'periodic')),
    startSpeed: value(args, 'start-speed', read.number),
    endSpeed: value(args, 'end-speed', read.number),
    period: value(args, 'period', read.positive),
    tension: value(args, 'tension', read.numbers),
    bias: value(args, 'bias', read.numbers),
    turns: value(args, 'turns', read.turns),
    inPlace: args.flags.has('in-place') || undefined,
    reference: value(args, 'reference', read.key),
    patches: value(args, 'patches', read.wholeFrom(1)),
    stretch: value(args, 'stretch', read.oneOf('linear', 'log')),
    ghostFaces: value(args, 'ghost-faces', (text, option) => (text === 'off' ? 0 : read.wholeFrom(4)(text, option))),
    transfer: value(args, 'transfer', read.oneOf('exact', 'paper')),
    placement: value(args, 'placement', read.oneOf('vertices', 'optimal')),
    precision: value(args, 'precision', read.oneOf('single', 'double', 'exact')),
    startTangent: undefined,
    endTangent: undefined,
  });
}

export function exportOptions(args: Arguments, output: string): Partial<ExportOptions> {
  const times = value(args, 'at', read.numbers);
  const frames = value(args, 'frames', read.wholeFrom(2));
  const range = value(args, 'range', read.range);
  const duration = value(args, 'duration', read.positive);
  if (times && (frames || range)) throw new UsageError('give either --at or --frames and --range');
  const common = given<ExportOptions>({
    format: formatOf(output), times, frames, range, duration, pose: undefined, inPlace: undefined,
  });
  if (output.endsWith('/') || times?.length === 1 || common.format === 'glb') return common;
  throw new UsageError(`${output} holds one shape: give one --at time, or a folder (ending in /) for several`);
}

function formatOf(output: string): ExportOptions['format'] {
  if (output.endsWith('/') || /\.obj$/i.test(output)) return 'obj';
  if (/\.glb$/i.test(output)) return 'glb';
  if (/\.ply$/i.test(output)) return 'ply';
  throw new UsageError(`--output: '${output}' ends neither in .glb, .obj or .ply nor, as a folder, in /`);
}
