/** The built-in samples: a list and their files, fetched from beside the page. */
import type { InputFile } from '../../engine/api/types.ts';
import type { Boundary } from '../../engine/api/types.ts';
import { BOUNDARIES } from '../../model/state.ts';

export interface Sample {
  id: string;
  title: string;
  description: string;
  files: string[];
  /** Times of the keys; null = the file's own or evenly spaced. */
  times: number[] | null;
  boundary: Boundary;
}

const FOLDER = 'samples/';

export async function fetchSamples(): Promise<Sample[]> {
  const response = await request(`${FOLDER}samples.json`);
  const list: unknown = await response.json();
  return Array.isArray(list) ? list.flatMap(readSample) : [];
}

export async function fetchSample(sample: Sample, signal: AbortSignal): Promise<InputFile[]> {
  return Promise.all(
    sample.files.map(async (name) => {
      const response = await request(FOLDER + name, signal);
      return { name, bytes: new Uint8Array(await response.arrayBuffer()) };
    }),
  );
}

async function request(path: string, signal?: AbortSignal): Promise<Response> {
  const response = await fetch(new URL(path, document.baseURI), signal ? { signal } : {});
  if (!response.ok)
    throw new Error(
      `The sample could not be fetched: ${path} answered ${response.status}. Is the page's folder complete?`,
    );
  return response;
}

function readSample(entry: unknown): Sample[] {
  if (typeof entry !== 'object' || entry === null) return [];
  const { id, title, description, file, files, times, boundary } = entry as Record<string, unknown>;
  const names = Array.isArray(files) ? files : [file];
  if (typeof id !== 'string' || !names.every((name) => typeof name === 'string')) return [];
  return [
    {
      id,
      title: typeof title === 'string' ? title : id,
      description: typeof description === 'string' ? description : '',
      files: names,
      times: Array.isArray(times) && times.every((time) => Number.isFinite(time)) ? times : null,
      boundary: BOUNDARIES.find((known) => known === boundary) ?? 'natural',
    },
  ];
}
