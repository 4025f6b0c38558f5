import { describe, expect, it } from 'vitest';
import { GONE_FLAGS, goneFlags } from '../../../web/engine/api/gone-options.ts';
import { ENCODING, EXPORT, IMPORT, MOTION, PER_KEY, optionsIn } from '../../../web/engine/api/option-table.ts';
import { parseArguments, UsageError } from '../../../web/cli/arguments.ts';
import {
  checkFit,
  COMPLETE,
  exportOptions,
  HELP,
  importOptions,
  sequenceOptions,
  withProject,
} from '../../../web/cli/settings.ts';
import { fittedRegions } from '../../../web/cli/timing.ts';

const parse = (...words: string[]) => parseArguments(words, COMPLETE);

it('timing is fitted or given, for keys at the times of their animation', () => {
  const regions = ['whole', '1', '16', 'off'].map((value) => fittedRegions(parse(`--fit-timing=${value}`)));
  expect(regions).toEqual([1, 1, 16, 0]);
  expect(fittedRegions(parse('--swing=1,0'))).toBe(0);
  for (const word of ['--earlier=0.1,0', '--swing=1,0', '--key-times=0,1', '--every-frame'])
    expect(() => fittedRegions(parse('--fit-timing=whole', word))).toThrow(/exclude each other/);
  for (const value of ['0', '65', '2.5', 'all'])
    expect(() => fittedRegions(parse(`--fit-timing=${value}`))).toThrow(UsageError);
});

describe('the command line', () => {
  it('takes values behind = or as the next word, negative ones too', () => {
    const { files, values } = parse('a.glb', '--at=-0.3,1.3', '--range', '-1:2', '--output', 'out/', 'b.glb');
    expect(files).toEqual(['a.glb', 'b.glb']);
    expect(Object.fromEntries(values)).toEqual({ at: '-0.3,1.3', range: '-1:2', output: 'out/' });
    expect(parse('--at', '-0.3,1.3').values.get('at')).toBe('-0.3,1.3');
  });

  it('accepts repeatable options several times', () => {
    expect(importOptions(parse('--object', 'Body', '--object=left, right'))).toEqual({
      objects: ['Body', 'left, right'],
    });
    expect(importOptions(parse('--object', 'Body'))).toEqual({ objects: ['Body'] });
  });

  it('reads everything after -- as a file', () => {
    expect(parse('--', '--at', '-x.glb').files).toEqual(['--at', '-x.glb']);
  });

  it.each([
    [['--bounday', 'x']],
    [['-o', 'x']],
    [['--at']],
    [['--at', '--report', 'r']],
    [['--at=']],
    [['--at=1', '--at=2']],
    [['--in-place=1']],
  ])('refuses %j', (words) => {
    expect(() => parse(...words)).toThrow(UsageError);
  });

  it('explains every option', () => {
    const named = new Set([...HELP.matchAll(/--([a-z-]+)/g)].map(([, name]) => name));
    const offered = [...COMPLETE.options, ...COMPLETE.flags].filter((name) => !GONE_FLAGS.includes(name));
    for (const name of offered) expect(named).toContain(name);
  });

  it('offers the options of the table, with the same text', () => {
    const text = HELP.replace(/\s+/g, ' ');
    for (const [name, option] of [ENCODING, MOTION, PER_KEY, IMPORT, EXPORT].flatMap(optionsIn)) {
      if (option.flag === undefined) continue;
      const value = option.value ?? (option.kind === 'choice' ? option.choices.join('|') : '');
      expect(text, name).toContain(` --${option.flag} ${value}${value && ' '}${option.help} `);
      expect([...COMPLETE.options, ...COMPLETE.flags], name).toContain(option.flag);
    }
    for (const row of HELP.split('\n')) expect(row.length, row).toBeLessThanOrEqual(112);
  });
});

describe('the values of options', () => {
  it('become options of the engine, with 0-based keys', () => {
    const args = parse(
      '--reference',
      '2',
      '--turns',
      '2:1,3:-2',
      '--boundary=hermite',
      '--start-speed=0',
      '--period',
      '1.5',
      '--in-place',
    );
    expect(sequenceOptions(args)).toEqual({
      reference: 1,
      turns: [
        { key: 1, turns: 1 },
        { key: 2, turns: -2 },
      ],
      boundary: 'hermite',
      startSpeed: 0,
      period: 1.5,
      inPlace: true,
    });
    expect(sequenceOptions(parse('--turns', '2:1@3,3:-2'))).toEqual({
      turns: [
        { key: 1, turns: 1, component: 2 },
        { key: 2, turns: -2 },
      ],
    });
    expect(importOptions(parse('--key-times=0,.4,1e0', '--animation', '0', '--sample', '0,0.2'))).toEqual({
      keyTimes: [0, 0.4, 1],
      animation: 0,
      sample: [0, 0.2],
    });
    expect(importOptions(parse('--animation', 'Walk', '--sample', '5'))).toEqual({ animation: 'Walk', sample: 5 });
    expect(exportOptions(parse('--frames', '3', '--range=-0.3:1.3'), 'o.glb')).toEqual({
      format: 'glb',
      name: 'o',
      frames: 3,
      range: [-0.3, 1.3],
    });
    expect(exportOptions(parse('--at=-0.3,1.3'), 'out/')).toEqual({ format: 'obj', times: [-0.3, 1.3] });
  });

  it('refuse speeds at the ends of a motion that is straight between keys', () => {
    for (const method of ['geodesic', 'linear'])
      expect(() => sequenceOptions(parse('--boundary=hermite', '--method', method))).toThrow(UsageError);
    for (const method of ['lri', 'cubic-vertex', 'rotation-strain', 'rimd'])
      expect(sequenceOptions(parse('--boundary=hermite', '--method', method))).toEqual({ boundary: 'hermite', method });
  });

  it('refuse ends, tension and bias with methods whose shapes are fitted', () => {
    for (const method of ['lengths', 'shell'])
      for (const flag of ['--boundary=hermite', '--boundary=periodic', '--tension=0,1', '--bias=0,1'])
        expect(() => sequenceOptions(parse(flag, '--method', method))).toThrow(/ requires --method lri, /);
    expect(sequenceOptions(parse('--method=lengths', '--space-faces=500', '--boundary=natural'))).toEqual({
      method: 'lengths',
      spaceFaces: 500,
      boundary: 'natural',
    });
  });

  it('refuse holding with methods that do not support it', () => {
    for (const method of ['geodesic', 'linear', 'cubic-vertex', 'rotation-strain', 'rimd', 'lengths', 'shell'])
      for (const held of ['--hold=on', '--pin=3'])
        expect(() => sequenceOptions(parse(held, '--method', method))).toThrow(/--method lri/);
    expect(sequenceOptions(parse('--hold=off', '--method=linear'))).toEqual({ hold: 'off', method: 'linear' });
    expect(sequenceOptions(parse('--hold=on', '--method=lri'))).toEqual({ hold: 'on', method: 'lri' });
    // Former names of the option's values.
    for (const before of ['contact', 'anchored'])
      expect(sequenceOptions(parse(`--hold=${before}`, '--precision=double'))).toEqual({
        hold: 'on',
        precision: 'exact',
      });
  });

  it('take flags of earlier versions without effect', () => {
    expect(sequenceOptions(parse('--own-paths=absolute', '--method=linear'))).toEqual({ method: 'linear' });
    expect(goneFlags(parse('--own-paths=absolute').values)).toEqual(['own-paths']);
    expect(goneFlags(parse('--own-paths=off').values)).toEqual([]);
  });

  it('refuse kept lengths with other methods, ends and options', () => {
    for (const other of [
      '--method=lengths',
      '--method=linear',
      '--boundary=periodic',
      '--hold=on',
      '--pin=3',
      '--turns=2:1',
    ])
      expect(() => sequenceOptions(parse('--keep-lengths=1', other))).toThrow(/--keep-lengths/);
    expect(() => sequenceOptions(parse('--keep-lengths=4'))).toThrow(/from 0 to 3/);
    expect(sequenceOptions(parse('--keep-lengths=3', '--tension=0,1'))).toEqual({ keepLengths: 3, tension: [0, 1] });
  });

  it('are checked together with the project of the file, by the names of their flags', () => {
    const project = { keepLengths: 2, tension: [0, 0], bias: [0, 0], turns: [], pins: [] };
    const said: string[] = [];
    const left = (...[own, given]: [object, object]) => withProject(own, given, (warning) => said.push(warning));
    expect(left(project, { boundary: 'periodic' })).toMatchObject({ boundary: 'periodic', keepLengths: 0 });
    expect(left({ method: 'shell', tension: [0, 1] }, {})).toMatchObject({ method: 'shell', tension: [] });
    expect(left({ hold: 'on', pins: [] }, { method: 'rimd' })).toMatchObject({ method: 'rimd', hold: 'off' });
    expect(said.map((text) => text.split(' (')[0])).toEqual([
      '--keep-lengths requires --boundary natural, so --keep-lengths is left out',
      '--tension requires --method lri, geodesic, linear, cubic-vertex, rotation-strain or rimd, so --tension is left out',
      '--hold requires --method lri, so --hold is left out',
    ]);
    expect(() => withProject({ method: 'rimd' }, { hold: 'on' })).toThrow(
      '--hold requires --method lri (the file is a project, which sets the options that are not given)',
    );
    expect(withProject({ ...project, method: 'shell', keepLengths: 0 }, { spaceFaces: 500 })).toMatchObject({
      method: 'shell',
      spaceFaces: 500,
    });
    expect(withProject(null, { hold: 'on' })).toEqual({ hold: 'on' });
    expect(() => withProject(null, { hold: 'on', method: 'linear' })).toThrow(/requires --method lri$/);
    expect(withProject({ method: 'shell' }, { hold: 'on', method: 'lri' })).toMatchObject({ hold: 'on' });
  });

  it('refuse flags of fitted shapes where none are fitted, and mixtures of keys where some are', () => {
    expect(() => checkFit(parse('--space-faces=500'), {}, ['lri', 'rimd'])).toThrow(/--space-faces requires/);
    expect(() => checkFit(parse('--space-samples=12'), { keepLengths: 1 }, ['lri'])).toThrow(
      /--space-samples requires/,
    );
    expect(() => checkFit(parse('--blend=0.5,0.5'), {}, ['shell'])).toThrow('--method shell does not support');
    expect(() => checkFit(parse('--blend=0.5,0.5'), { keepLengths: 1 }, ['lri'])).toThrow(/--keep-lengths does not/);
    checkFit(parse('--space-faces=500'), { keepLengths: 1 }, ['lri']);
    checkFit(parse('--space-faces=500', '--space-samples=12'), {}, ['lri', 'lengths']);
    checkFit(parse('--blend=0.5,0.5'), {}, ['lri']);
  });

  it('refuse full turns with methods that do not support them', () => {
    for (const method of ['linear', 'cubic-vertex', 'rotation-strain', 'rimd', 'lengths', 'shell'])
      expect(() => sequenceOptions(parse('--turns=2:1', '--method', method))).toThrow(/--turns/);
    expect(sequenceOptions(parse('--turns=2:1', '--method=geodesic'))).toMatchObject({ method: 'geodesic' });
  });

  it.each([
    ['--reference=0'],
    ['--turns=1:1'],
    ['--turns=2'],
    ['--turns=2:1:3'],
    ['--turns=2:1@0'],
    ['--turns=2:1@'],
    ['--turns=2@1'],
    ['--turns=2:1@1@1'],
    ['--turns=2:1@a'],
    ['--period=0'],
    ['--start-speed=fast'],
    ['--start-speed=0x10'],
    ['--stretch=both'],
    ['--patches=2.5'],
    ['--ghost-faces=3'],
    ['--ghost-faces=x'],
    ['--placement=free'],
    ['--transfer=none'],
    ['--tension=1,,2'],
    ['--tension=0,1e308'],
    ['--bias=0,2'],
    ['--turns=2:1000000000'],
    ['--period=1e308'],
    ['--start-speed=1e308'],
    ['--patches=1000000'],
    ['--ghost-faces=3000000000'],
  ])('of a sequence refuse %s', (word) => {
    expect(() => sequenceOptions(parse(word))).toThrow(UsageError);
  });

  it.each([
    [['--at=1', '--frames=3'], 'o.glb'],
    [['--frames=1'], 'o.glb'],
    [['--range=1:1'], 'o.glb'],
    [['--range=1'], 'o.glb'],
    [[], 'o.fbx'],
    [[], 'o.obj'],
    [['--at=0,1'], 'o.ply'],
    [['--at=1,x'], 'o.glb'],
    [['--duration=-1'], 'o.glb'],
    [['--duration=1e308'], 'o.glb'],
    [['--frames=1000000000'], 'o.glb'],
    [['--range=1e308:1.7e308'], 'o.glb'],
    [['--at=1e308'], 'o.glb'],
  ])('of an export refuse %j to %s', (words, output) => {
    expect(() => exportOptions(parse(...words), output)).toThrow(UsageError);
  });

  it.each(['--sample=1000000000', '--sample=0,1e300', '--key-times=0,1e308', '--unit=1e308', '--unit=-1'])(
    'of an import refuse %s',
    (word) => {
      expect(() => importOptions(parse(word))).toThrow(UsageError);
    },
  );

  it('that are out of range are reported with the option and its range', () => {
    expect(() => exportOptions(parse('--frames=1000000000'), 'o.glb')).toThrow(
      '--frames: must be a whole number from 2 to 100,000',
    );
  });

  it.each(['--reference=2147483648', '--turns=2147483648:1', '--pin=3:stay=2147483648'])(
    'that name a key far beyond the last one are reported: %s',
    (word) => {
      expect(() => sequenceOptions(parse(word))).toThrow(/there is no key 2147483648/);
    },
  );

  it('of a ghost mesh are a number of faces or off', () => {
    expect(sequenceOptions(parse('--ghost-faces', '500', '--placement=optimal'))).toEqual({
      ghostFaces: 500,
      placement: 'optimal',
    });
    expect(sequenceOptions(parse('--ghost-faces', 'off', '--transfer', 'paper'))).toEqual({
      ghostFaces: 0,
      transfer: 'paper',
    });
  });
});
