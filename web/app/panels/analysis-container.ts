/** The container of the Analysis panel, filled once the first shape is on the screen. */
import { h } from '../../ui/dom.ts';
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
  const place = h(
    'section',
    { class: 'panel', id: 'panel-analysis', 'aria-labelledby': 'analysis-title', 'data-testid': 'panel-analysis' },
    h('header', {}, h('h2', { id: 'analysis-title' }, 'Analysis')),
  );
  const fill = async (): Promise<AnalysisPanel> => {
    const { createAnalysisPanel } = await import('./analysis-panel.ts');
    const panel = createAnalysisPanel(place, cache, events);
    onFilled();
    return panel;
  };
  return lazyComponent(fill, events.onError, place);
}
