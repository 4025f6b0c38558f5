/** The built-in samples: their list and files, fetched from beside the page. */
import type { Boundary, Hold, ImportOptions, InputFile } from '../../engine/api/types.ts';
import { BOUNDARIES } from '../../model/state.ts';
import type { OpenFile } from '../session/workspace.ts';

export interface Sample {
  id: string;
  title: string;
  description: string;
  files: string[];
  /** Whether `web/sculpt` makes the sample in the page; otherwise it is fetched. */
  made: boolean;
  /** Key names; null for those in the files. */
  names: string[] | null;
  /** Key times; null for those in the file, or even spacing. */
  times: number[] | null;
  boundary: Boundary;
  hold: Hold;
}

const FOLDER = 'samples/';

/** Samples made in the page. */
const MADE: readonly Sample[] = [
  {
    id: 'column',
    title: 'Twisted column',
    description: 'A column twisted by 0, 180 and 350 degrees: blending positions pinches it to a thread.',
    files: ['column.glb'],
    made: true,
    names: ['Straight', 'Half a turn', 'A whole turn'],
    times: [0, 0.5, 1],
    boundary: 'natural',
    hold: 'off',
  },
  {
    id: 'turret',
    title: 'Turret',
    description:
      'A column whose upper part shrinks to a fifth. Extrapolate it to compare linear and logarithmic stretch.',
    files: ['turret.glb'],
    made: true,
    names: ['Whole', 'Smaller, turned', 'A fifth'],
    times: [0, 0.5, 1],
    boundary: 'natural',
    hold: 'off',
  },
  {
    id: 'serpent',
    title: 'Serpent',
    description: '307,000 faces, with every scale modelled. It winds, coils and raises its head.',
    files: ['serpent.glb'],
    made: true,
    names: ['Winding', 'Winding back', 'Coiled'],
    times: [0, 0.5, 1],
    boundary: 'natural',
    hold: 'off',
  },
];

export async function fetchSamples(): Promise<Sample[]> {
  const response = await request(`${FOLDER}samples.json`);
  const list: unknown = await response.json().catch(() => {
    throw new Error(`${FOLDER}samples.json is not JSON. Check that the page's folder is complete.`);
  });
  return [...(Array.isArray(list) ? list.flatMap(readSample) : []), ...MADE];
}

/** `detail`: values below 1 suffice for thumbnails of samples made in the page. */
export async function fetchSample(sample: Sample, signal: AbortSignal, detail = 1): Promise<InputFile[]> {
  if (sample.made) return makeSample(sample.id, detail);
  return Promise.all(
    sample.files.map(async (name) => {
      const response = await request(FOLDER + name, signal);
      return { name, bytes: new Uint8Array(await response.arrayBuffer()) };
    }),
  );
}

/** Import options of a sample's files. */
export const readingOf = ({ times }: Sample): ImportOptions => (times ? { keyTimes: times } : {});

/** Makes one of the samples of `web/sculpt`. */
export async function makeSample(id: string, detail = 1): Promise<OpenFile[]> {
  const { make } = await import('../../sculpt/make.ts');
  return [{ name: `${id}.glb`, ...(await make(id, detail)) }];
}

async function request(path: string, signal?: AbortSignal): Promise<Response> {
  const response = await fetch(new URL(path, document.baseURI), signal ? { signal } : {}).catch((cause: unknown) => {
    throw new Error(`The sample could not be fetched: ${path}. Check the connection and try again.`, { cause });
  });
  // Some hosts answer missing files with a page.
  const isPage = response.headers.get('content-type')?.startsWith('text/html');
  if (!response.ok || isPage)
    throw new Error(
      `The sample could not be fetched: ${path} returned ${isPage && response.ok ? 'a web page' : `status ${response.status}`}. Check that the page's folder is complete.`,
    );
  return response;
}

function readSample(entry: unknown): Sample[] {
  if (typeof entry !== 'object' || entry === null) return [];
  const { id, title, description, file, files, times, boundary, hold } = entry as Record<string, unknown>;
  const names = Array.isArray(files) ? files : [file];
  if (typeof id !== 'string' || !names.every((name) => typeof name === 'string')) return [];
  return [
    {
      id,
      title: typeof title === 'string' ? title : id,
      description: typeof description === 'string' ? description : '',
      files: names,
      made: false,
      names: null,
      times: Array.isArray(times) && times.every((time) => Number.isFinite(time)) ? times : null,
      boundary: BOUNDARIES.find((known) => known === boundary) ?? 'natural',
      hold: hold === 'on' ? hold : 'off',
    },
  ];
}
