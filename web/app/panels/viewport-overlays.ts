/** Overlays of the viewport: views, labels, divider, phase and messages. */
import { OFF_CURVE } from '../../model/time-scale.ts';
import { viridisGradient } from '../../plots/viridis.ts';
import { createColourBar } from '../../ui/colour-bar.ts';
import { createDivider } from '../../ui/divider.ts';
import { createErrorMessage, createFitHint, createProgress, createWelcome } from '../../ui/messages.ts';
import type { WelcomeProps } from '../../ui/messages.ts';
import { createPhaseLabel } from '../../ui/phase-label.ts';
import type { PhaseLabelProps } from '../../ui/phase-label.ts';
import { createTileLabels } from '../../ui/tile-labels.ts';
import { createViewBar } from '../../ui/view-bar.ts';
import type { Context } from '../actions/context.ts';
import type { Commands } from '../actions/table.ts';
import { actionButtons } from './action-buttons.ts';
import type { Connect, Shown } from './connect.ts';
import { shownPhase } from './timeline-area.ts';

export interface ViewportOverlays {
  labels: HTMLElement;
  /** Elements over the labels. */
  overlays: HTMLElement[];
  progress: HTMLElement;
  error: HTMLElement;
  fitHint: HTMLElement;
  toggleLook(): void;
}

export function createViewportOverlays(context: Context, commands: Commands, connect: Connect): ViewportOverlays {
  const { scene } = context.display;
  const views = actionButtons('views', context, commands, connect);
  const viewBar = createViewBar(views, {
    onView: commands.view,
    onSplit: commands.toggleSplit,
    onPresent: () => commands.present('shape'),
    onQr: commands.openLink,
    onUp: (up) => void commands.standUp(up),
  });
  const divider = createDivider((split) => commands.split(split));
  const colourBar = createColourBar(viridisGradient('var(--ramp-direction, to top)'));
  const overlays = [
    connect(divider, ({ state }) => {
      const [right, left] = scene.shownLabels;
      return {
        share: scene.isSplit ? state.view.split : null,
        left: left?.title ?? '',
        right: right?.title ?? '',
      };
    }),
    connect(colourBar, () => scene.colourBar),
    connect(createWelcome(commands.pickFiles), (shown) => welcomeProps(shown, context)),
    connect(createPhaseLabel(commands.markLost), phaseProps),
    connect(viewBar, ({ state, opened, disabled }) => ({
      view: state.view,
      up: opened.orientation?.up ?? null,
      disabled,
    })),
  ];
  const error = createErrorMessage(commands.closeError, commands.reload);
  return {
    labels: connect(createTileLabels(), ({ state: { view } }) => ({
      labels: scene.shownLabels,
      split: scene.isSplit,
      strip: view.film,
    })),
    overlays,
    progress: connect(createProgress(commands.cancel), ({ page }) => page.working),
    error: connect(error, ({ page }) => page.errorMessage),
    fitHint: connect(createFitHint(commands.fit), ({ disabled }) => !disabled && scene.outOfView),
    toggleLook: viewBar.toggleLook,
  };
}

/** No phase for a film strip, which shows many times, or for a first key, which is not part of the open motion. */
function phaseProps(shown: Shown): PhaseLabelProps {
  const { state, page, opened, disabled } = shown;
  const none = disabled || state.view.film || page.seen === 'first key';
  const phase = opened.blend ? OFF_CURVE : shownPhase(shown);
  return {
    phase: none ? null : phase,
    lost: {
      share: opened.indefinite / Math.max(opened.info?.report.faces ?? 0, 1),
      hasPlace: opened.indefiniteFace >= 0,
    },
  };
}

function welcomeProps({ state: { view }, page }: Shown, { display: { scene } }: Context): WelcomeProps {
  const labelled = scene.shownLabels.length > 0 && !scene.isSplit;
  const message = page.errorMessage !== null || page.working !== null;
  return {
    wanted: page.welcome,
    isCovered: scene.colourBar !== null || labelled || message,
    // The sentence appears immediately, even before the divider is drawn.
    split: view.split !== null && view.compare.length === 1,
  };
}
