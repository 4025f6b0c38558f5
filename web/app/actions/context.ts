/** What commands work on: the parts of the app. The parts do not know the commands. */
import type { AppState, Plot } from '../../model/state.ts';
import type { End } from '../../model/speeds.ts';
import type { Lazy } from '../../ui/lazy.ts';
import type { Offer } from '../../ui/messages.ts';
import type { ThemeSwitch } from '../../ui/theme.ts';
import type { AnalysisCache } from '../analysis/analysis-cache.ts';
import type { MotionSpeedFollower } from '../analysis/motion-speed.ts';
import type { Display } from '../drawing/display.ts';
import type { ExportController } from '../export/export-controller.ts';
import type { RememberedFiles } from '../kept/remembered-files.ts';
import type { Session } from '../session/session.ts';
import type { Animation } from '../sources/animation.ts';
import type { Opener } from '../sources/opener.ts';
import type { PageLink } from '../sources/page-link.ts';
import type { TakeFiles } from '../sources/take-files.ts';
import type { Undo } from '../sources/undo.ts';
import type { View } from '../../model/state.ts';
import type { Feedback } from '../view/feedback.ts';
import type { ViewStateHolder } from '../view/view-state.ts';

export interface Context extends Ways {
  session: Session;
  display: Display;
  viewState: ViewStateHolder;
  feedback: Feedback;
  theme: ThemeSwitch;
  analysis: AnalysisCache;
  motionSpeed: MotionSpeedFollower;
  takeFiles: TakeFiles;
  /** Offers what can be done about the files that were just opened; null takes the offer back. */
  offerImport(offer: Offer | null): void;
  guide: Lazy<GuideControl>;
  /** Not before the page is made. */
  readonly overlays: Overlays;
}

/** What opens and saves: files and samples, work of an earlier visit, the page's address, exports. */
export interface Ways {
  files: Opener;
  remembered: RememberedFiles;
  undo: Undo;
  animation: Lazy<Animation>;
  /** Shows the animation that the keys are of, or that of other files, beside the motion. */
  showOriginal(shown: boolean): Promise<void>;
  /** Opens a project of the user again. */
  openOwn(project: string): Promise<void>;
  link: PageLink;
  exporting: Lazy<ExportController>;
  titleOf(source: AppState['source']): string;
}

/** What commands need of the guide. */
export interface GuideControl {
  /** The plot that the page on show speaks of, or null. */
  readonly plot: Plot | null;
  /** Stops opening a page of it, or the way back; false if neither was under way. */
  cancel(): boolean;
  close(): Promise<void>;
}

/** What opens over the page. */
export interface Overlays {
  /** Have the user choose files: to open, to add as keys, for a tangent, or to compare with. */
  pickFiles(): void;
  pickKeys(): void;
  pickTangent(end: End): void;
  pickTruth(): void;
  openExport(): void;
  openEmbed(snippet: string): void;
  openHelp(): void;
  openLink(link: string | null): void;
  toggleLook(): void;
  toggleClock(): void;
}

/** What most commands on the view do. */
export function changeView({ session: { store } }: Context, change: Partial<View>): void {
  store.set({ view: { ...store.get().view, ...change } });
}
