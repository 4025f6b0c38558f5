/**
 * Assigns intended times to recorded frames, which carry clock times. The recorder may skip or repeat frames, so each
 * frame keeps its relative time. Packets may arrive out of display order.
 */
export function frameTimestamps(
  stamps: readonly number[],
  frames: number,
  framesPerSecond: number,
): { timestamp: number; duration: number }[] {
  const order = stamps.map((_, index) => index).sort((a, b) => stamps[a]! - stamps[b]!);
  const seconds = frames / framesPerSecond;
  const first = stamps[order[0]!] ?? 0;
  const last = stamps[order.at(-1)!] ?? 0;
  const mean = (last - first) / Math.max(stamps.length - 1, 1);
  const scale = last > first ? seconds / (last - first + mean) : 1;
  const all = stamps.length === frames;
  const begins = order.map((index, place) => (all ? place / framesPerSecond : (stamps[index]! - first) * scale));
  const times = stamps.map(() => ({ timestamp: 0, duration: 0 }));
  order.forEach((index, place) => {
    const timestamp = begins[place]!;
    times[index] = { timestamp, duration: (begins[place + 1] ?? seconds) - timestamp };
  });
  return times;
}
