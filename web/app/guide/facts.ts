/** Numbers that the guide's pages show. */
import type { AppState } from '../../model/state.ts';
import type { TileLabel } from '../../ui/tile-labels.ts';
import type { OpenedState } from '../view/view-state.ts';
import type { Facts } from './guide-page.ts';

/** The facts on the open motion; null while nothing is open or its numbers are unknown. */
export function factsOf(
  { info, stats, ms }: OpenedState,
  { doc }: AppState,
  labels: readonly TileLabel[],
): Facts | null {
  if (!info || !stats) return null;
  return {
    keyTimes: doc.keys.map(({ time }) => time),
    faces: info.report.faces,
    patches: stats.patches,
    volumes: labels.map(({ volume }) => volume),
    stats,
    stretch: doc.encoding.stretch,
    ms,
  };
}
