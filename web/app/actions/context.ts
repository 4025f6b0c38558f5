/** The input of commands: the parts of the app. No part imports the commands. */
import type { AppState, Plot } from '../../model/state.ts';
import type { End } from '../../model/speeds.ts';
import type { Lazy } from '../../ui/lazy.ts';
import type { Offer } from '../../ui/messages.ts';
import type { ThemeSwitch } from '../../ui/theme.ts';
import type { AnalysisCache } from '../analysis/analysis-cache.ts';
import type { MotionSpeedFollower } from '../analysis/motion-speed.ts';
import type { Display } from '../drawing/display.ts';
import type { ExportController } from '../export/export-controller.ts';
import type { RememberedFiles } from '../storage/remembered-files.ts';
import type { Session } from '../session/session.ts';
import type { Animation } from '../sources/animation.ts';
import type { Opener } from '../sources/opener.ts';
import type { PageLink } from '../sources/page-link.ts';
import type { FileIntake } from '../sources/file-intake.ts';
import type { Undo } from '../sources/undo.ts';
import type { View } from '../../model/state.ts';
import type { Feedback } from '../view/feedback.ts';
import type { ViewStateHolder } from '../view/view-state.ts';

export interface Context extends IoControllers {
  session: Session;
  display: Display;
  viewState: ViewStateHolder;
  feedback: Feedback;
  theme: ThemeSwitch;
  analysis: AnalysisCache;
  motionSpeed: MotionSpeedFollower;
  fileIntake: FileIntake;
  /** Offers follow-up actions for the files just opened; null withdraws the offer. */
  offerImport(offer: Offer | null): void;
  guide: Lazy<GuideControl>;
  /** Do nothing until the page is created. */
  overlays: Overlays;
}

/** Opening and saving: files, samples, work of an earlier visit, the page's URL, exports. */
export interface IoControllers {
  files: Opener;
  remembered: RememberedFiles;
  undo: Undo;
  animation: Lazy<Animation>;
  /** Shows the source animation, or that of other files, beside the motion. */
  showOriginal(shown: boolean): Promise<void>;
  /** Reopens a project of the user. */
  openOwn(project: string): Promise<void>;
  link: PageLink;
  exporting: Lazy<ExportController>;
  titleOf(source: AppState['source']): string;
}

/** The part of the guide that commands use. */
export interface GuideControl {
  readonly isOpen: boolean;
  /** Plot of the current page, or null. */
  readonly plot: Plot | null;
  /** Stops opening a page of the guide or leaving it; false if neither is in progress. */
  cancel(): boolean;
  close(): Promise<void>;
}

/** Dialogs and file choosers over the page. */
export interface Overlays {
  /** File choosers: to open, to add keys, to set a tangent, or to compare. */
  pickFiles(): void;
  pickKeys(): void;
  pickTangent(end: End): void;
  pickReference(): void;
  openExport(): void;
  openEmbed(snippet: string): void;
  openHelp(): void;
  openLink(link: string | null): void;
  toggleLook(): void;
  toggleClock(): void;
}

export function noOverlays(): Overlays {
  const nothing = (): void => undefined;
  return {
    pickFiles: nothing,
    pickKeys: nothing,
    pickTangent: nothing,
    pickReference: nothing,
    openExport: nothing,
    openEmbed: nothing,
    openHelp: nothing,
    openLink: nothing,
    toggleLook: nothing,
    toggleClock: nothing,
  };
}

/** Shared by most commands on the view. */
export function changeView({ session: { store } }: Context, change: Partial<View>): void {
  store.set({ view: { ...store.get().view, ...change } });
}
