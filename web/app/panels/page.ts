/** The page: its components, the keyboard, and one redraw per animation frame. */
import { REFUSED } from '../../ui/controls.ts';
import { setAttribute } from '../../ui/dom.ts';
import { createHeader } from '../../ui/header.ts';
import { listenToCamera } from '../../viewer/camera-keys.ts';
import type { Context } from '../actions/context.ts';
import type { Commands } from '../actions/table.ts';
import { ownFiles } from '../sources/own-files.ts';
import type { Offers } from '../view/offers.ts';
import { listenToClicks, listenToHover } from '../view/window-events.ts';
import { actionButtons } from './action-buttons.ts';
import { createConnections, shownOf } from './connect.ts';
import type { Connect } from './connect.ts';
import { createTimelineArea } from './timeline-area.ts';
import { listenToArrows, listenToKeys } from './keyboard.ts';
import type { Layout } from './layout.ts';
import { createChoosers, createDialogs } from './overlays.ts';
import { createPinsInView } from './pins-in-view.ts';
import type { PinsInView } from './pins-in-view.ts';
import { createPresentation } from './presentation.ts';
import { connectImportDialog } from './import-dialog.ts';
import { createSidebar } from './sidebar.ts';
import type { Sidebar } from './sidebar.ts';
import { createViewportOverlays } from './viewport-overlays.ts';

export interface PageParts {
  root: HTMLElement;
  layout: Layout;
  context: Context;
  commands: Commands;
  offers: Offers;
  /** Called after a complete redraw. */
  onDrawn(): void;
}

/** Returns a function that schedules a redraw on the next animation frame. */
export function createPage(parts: PageParts): () => void {
  const { root, layout, context, commands, offers } = parts;
  const { store } = context.session;
  const { feedback } = context;
  const { connect, update } = createConnections();
  const onFilled = (): void => layout.present(store.get().view.present);
  const viewportOverlays = createViewportOverlays(context, commands, connect);
  const timelineArea = createTimelineArea(commands, connect, feedback.onError);
  const sidebar = createSidebar({ context, commands, connect, onFilled });
  const pins = createPinsInView(context, commands);
  const presentation = createPresentation({
    presented: () => store.get().view.present,
    present: commands.present,
    show: layout.present,
    say: feedback.say,
  });
  connect(presentation, ({ state }) => state.view.present);
  const dialogs = createDialogs(commands, connect, feedback.onError);
  const choosers = createChoosers(commands, timelineArea, sidebar.motionPanel);
  layout.mount(root, {
    header: header(context, commands, connect),
    transport: timelineArea.transport,
    keyStrip: timelineArea.keyStrip.element,
    warnings: timelineArea.warnings,
    status: timelineArea.status,
    opening: connectImportDialog({
      sampling: sidebar.sampling,
      commands,
      connect,
      onError: feedback.onError,
      over: [viewportOverlays.progress, offers.imported.element],
      next: layout.viewport,
    }),
    overlays: [viewportOverlays.labels, pins.element, ...viewportOverlays.overlays, presentation.element],
    messages: [viewportOverlays.error, viewportOverlays.progress, viewportOverlays.fitHint, ...offers.elements],
    panels: sidebar.panels,
    floating: [...dialogs.elements, ...choosers.elements, feedback.toast],
  });
  listen(parts, sidebar, pins);
  const redraw = onNextFrame(() => {
    if (waits(context)) return;
    const shown = shownOf(context);
    const { seen } = shown.page;
    setAttribute(layout.viewport, 'data-placing', shown.opened.placing);
    setAttribute(layout.viewport, 'data-dimmed', seen === 'dimmed' && !shown.disabled);
    // The shown shape's motion does not exist yet.
    setAttribute(layout.viewport.closest('.app')!, 'data-gone', seen === 'first key');
    update(shown);
    parts.onDrawn();
  });
  const { toggleLook } = viewportOverlays;
  const { toggleClock } = timelineArea;
  Object.assign(context.overlays, { ...dialogs, ...choosers, toggleLook, toggleClock });
  return redraw;
}

/** Components are not updated before the first shape is drawn. */
function waits({ session: { store }, display: { scene }, viewState }: Context): boolean {
  return store.get().source.kind !== 'none' && !scene.viewer.hasSeen && !viewState.page.errorMessage;
}

function onNextFrame(draw: () => void): () => void {
  let frame = 0;
  const drawNow = (): void => {
    frame = 0;
    draw();
  };
  return () => {
    if (frame === 0) frame = requestAnimationFrame(drawNow);
  };
}

function header(context: Context, commands: Commands, connect: Connect): HTMLElement {
  const { files } = context;
  const buttons = (place: 'start' | 'history' | 'end'): HTMLElement[] =>
    actionButtons(place, context, commands, connect);
  const component = createHeader(
    { start: buttons('start'), history: buttons('history'), end: buttons('end') },
    {
      onSample: (id) => void commands.sample(id),
      onOwn: (project) => void commands.own(project),
      onTheme: commands.nextTheme,
    },
  );
  return connect(component, ({ state, page, theme }) => ({
    samples: page.samples,
    sample: state.source.kind === 'sample' ? state.source.id : null,
    own: ownFiles(state, files.history.all, page.shelf),
    project: state.project,
    theme,
  }));
}

function listen({ layout: { viewport }, context, commands }: PageParts, { analysis }: Sidebar, pins: PinsInView): void {
  const { viewState, display, feedback } = context;
  document.addEventListener(REFUSED, ({ detail }: CustomEventInit<string>) => feedback.say(detail ?? ''));
  listenToKeys(context, commands);
  listenToArrows(context, viewport, commands);
  listenToCamera(display.scene.viewer, viewport);
  listenToHover(viewport, (x, y) => {
    if (viewState.opened.placing) pins.mark({ x, y });
  });
  listenToClicks(viewport, (x, y) => {
    if (viewState.opened.placing) return pins.place({ x, y });
    void analysis.need().then((panel) => panel?.clicked(() => display.scene.pick(x, y)));
  });
}
