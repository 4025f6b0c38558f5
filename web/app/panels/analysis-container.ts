/** The container of the Analysis panel, filled once the first shape is on the screen. */
import { panelSection } from '../../ui/controls.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import type { LazyComponent } from '../../ui/lazy.ts';
import type { AnalysisCache } from '../analysis/analysis-cache.ts';
import type { AnalysisPanel, AnalysisPanelEvents, AnalysisPanelProps } from './analysis-panel.ts';

export type AnalysisContainer = LazyComponent<AnalysisPanelProps, AnalysisPanel>;

/** `onFilled`: the figures now exist. */
export function createAnalysisContainer(
  cache: AnalysisCache,
  events: AnalysisPanelEvents,
  onFilled: () => void,
): AnalysisContainer {
  const place = panelSection('Analysis');
  const fill = async (): Promise<AnalysisPanel> => {
    const { createAnalysisPanel } = await import('./analysis-panel.ts');
    const panel = createAnalysisPanel(place, cache, events);
    onFilled();
    return panel;
  };
  return lazyComponent(fill, events.onError, place);
}
