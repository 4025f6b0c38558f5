/**
 * Videos in browsers without WebCodecs. The browser's recorder stamps frames by the clock, so recording takes at least
 * the video's duration. The file is then rewritten with the intended times and a length for seeking.
 */
import {
  BlobSource,
  BufferTarget,
  EncodedPacketSink,
  EncodedVideoPacketSource,
  Input,
  MP4,
  Mp4OutputFormat,
  Output,
  WEBM,
  WebMOutputFormat,
} from 'mediabunny';
import type { EncodedPacket } from 'mediabunny';
import { frameTimestamps } from './frame-timestamps.ts';
import { recordedType } from './recorded-types.ts';
import { bitrateOf } from './video.ts';
import type { VideoOptions } from './video.ts';

export async function write(options: VideoOptions): Promise<Blob> {
  return retimed(await record(options), options);
}

async function record({ format, frames, framesPerSecond, canvas, draw, onFrame, signal }: VideoOptions): Promise<Blob> {
  const stream = canvas.captureStream(0);
  const [track] = stream.getVideoTracks() as CanvasCaptureMediaStreamTrack[];
  const recorder = new MediaRecorder(stream, {
    mimeType: recordedType(format),
    videoBitsPerSecond: bitrateOf(canvas, framesPerSecond),
  });
  const chunks: Blob[] = [];
  recorder.ondataavailable = (event) => {
    if (event.data.size > 0) chunks.push(event.data);
  };
  const stopped = new Promise<void>((resolve, reject) => {
    recorder.onstop = () => resolve();
    recorder.onerror = () => reject(new Error('The browser stopped writing the video.'));
  });
  recorder.start(500);
  try {
    for (let frame = 0; frame < frames && !signal.aborted; frame += 1) {
      const next = performance.now() + 1000 / framesPerSecond;
      await draw(frame);
      track!.requestFrame();
      onFrame(frame + 1);
      await until(next);
    }
  } finally {
    recorder.stop();
    await stopped;
    for (const one of stream.getTracks()) one.stop();
  }
  signal.throwIfAborted();
  return new Blob(chunks, { type: `video/${format}` });
}

function until(time: number): Promise<void> {
  return new Promise((resolve) => window.setTimeout(resolve, Math.max(time - performance.now(), 0)));
}

/** The same frames with their intended times. */
async function retimed(recorded: Blob, { format, frames, framesPerSecond }: VideoOptions): Promise<Blob> {
  const input = new Input({ source: new BlobSource(recorded), formats: [format === 'mp4' ? MP4 : WEBM] });
  const track = await input.getPrimaryVideoTrack();
  const codec = await track?.getCodec();
  if (!track || !codec) return recorded;
  const packets: EncodedPacket[] = [];
  for await (const packet of new EncodedPacketSink(track).packets()) packets.push(packet);
  const target = new BufferTarget();
  const output = new Output({ format: format === 'mp4' ? new Mp4OutputFormat() : new WebMOutputFormat(), target });
  const source = new EncodedVideoPacketSource(codec);
  output.addVideoTrack(source);
  await output.start();
  const decoderConfig = (await track.getDecoderConfig()) ?? undefined;
  const times = frameTimestamps(
    packets.map(({ timestamp }) => timestamp),
    frames,
    framesPerSecond,
  );
  for (const [index, packet] of packets.entries())
    await source.add(packet.clone(times[index]), index === 0 ? { decoderConfig } : undefined);
  await output.finalize();
  return new Blob([target.buffer!], { type: `video/${format}` });
}
