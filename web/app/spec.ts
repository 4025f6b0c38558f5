/** What the document asks of the engine, as plain data: which keys, encoded how, moved how. */
import type { EncodingOptions, Method, MotionOptions } from '../engine/types.ts';
import type { Doc } from '../model/state.ts';
import { ignoresHermite, referenceKey } from '../model/state.ts';

/** One sequence is built per method that is shown; they share everything but the method. */
export interface Spec {
  order: number[];
  names: string[];
  times: number[];
  encoding: Pick<EncodingOptions, 'reference' | 'patches' | 'stretch'>;
  startTangentPose: number | null;
  endTangentPose: number | null;
  motion: Omit<MotionOptions, 'method'>;
  methods: Method[];
}

export function specOf(doc: Doc, compare: readonly Method[]): Spec {
  const { keys, motion, encoding, tension } = doc;
  const { method, ...rest } = motion;
  const hermite = motion.boundary === 'hermite';
  return {
    order: keys.map((key) => key.pose),
    names: keys.map((key) => key.name),
    times: keys.map((key) => key.time),
    encoding: { reference: referenceKey(doc), patches: encoding.patches, stretch: encoding.stretch },
    startTangentPose: hermite ? encoding.startTangentPose : null,
    endTangentPose: hermite ? encoding.endTangentPose : null,
    motion: { ...rest, tension: tension.some((value) => value !== 0) ? tension : [], turns: [], inPlace: false },
    methods: [method, ...compare.filter((other) => other !== method)],
  };
}

/** Specs with the same shape key are served by the same encodings and factorisations. */
export function shapeKey({ order, encoding, startTangentPose, endTangentPose }: Spec): string {
  return JSON.stringify([order, encoding, startTangentPose, endTangentPose]);
}

/** The boundary that a method makes use of: straight motion has no end derivatives. */
export function motionFor(spec: Spec, method: Method): MotionOptions {
  const boundary = ignoresHermite(method) && spec.motion.boundary === 'hermite' ? 'natural' : spec.motion.boundary;
  return { ...spec.motion, method, boundary };
}
