/** Commands on the page: link, colours, export, undo, cancel. */
import { DEFAULT_REQUEST } from '../../model/export-request.ts';
import type { ExportRequest } from '../../model/export-request.ts';
import type { Actions, Button } from './action.ts';
import { present } from './comparison.ts';
import type { Context } from './context.ts';
import { asked } from './files.ts';
import { showBlend } from './view.ts';

export const PAGE = {
  openLink: {
    keys: ['q'],
    shown: 'Q',
    does: 'QR code of the link',
    run: ({ overlays, link }) => overlays.openLink(link.address()),
  },
  nextTheme: { keys: ['d'], shown: 'D', does: 'Light, dark or system colours', run: ({ theme }) => theme.next() },
  openExport: {
    keys: ['e'],
    shown: 'E',
    does: 'Export',
    button: {
      in: 'end',
      testId: 'export',
      label: 'Export',
      icon: 'download',
      text: 'Export',
      kind: 'primary',
      now: ({ viewState }) => ({ disabled: viewState.opened.info === null }),
    },
    run(context) {
      const { info, exporting } = context.viewState.opened;
      if (!info) return undefined;
      context.overlays.openExport();
      return planExport(context, exporting.request);
    },
  },
  copyLink: {
    button: {
      in: 'end',
      testId: 'link',
      label: 'Copy a link to this view',
      icon: 'link',
      now: ({ session: { store } }) => ({ hidden: store.get().project !== null }),
    },
    run: ({ link }) => link.copy(),
  },
  remember: {
    button: {
      in: 'end',
      testId: 'remember',
      label: 'Remember these files on this computer',
      icon: 'bookmark',
      now: ({ session: { store }, viewState }) => ({
        hidden: store.get().project === null,
        pressed: viewState.page.remembered,
        hint: viewState.page.remembered
          ? 'These files are remembered in this browser, on this computer only; click to forget them'
          : 'Remember these files in this browser for the next visit; they stay on this computer',
      }),
    },
    run: ({ remembered }) => remembered.toggle(),
  },
  undo: {
    keys: ['ctrl+z'],
    shown: 'Ctrl+Z',
    does: 'Undo',
    edits: true,
    button: historyButton('undo', 'Undo', ({ undo }) => undo.undoLabel()),
    run: ({ undo }) => undo.undo(),
  },
  redo: {
    keys: ['ctrl+shift+z', 'ctrl+y'],
    shown: 'Ctrl+Shift+Z',
    does: 'Redo',
    edits: true,
    button: historyButton('redo', 'Redo', ({ undo }) => undo.redoLabel()),
    run: ({ undo }) => undo.redo(),
  },
  stepBack: {
    keys: ['escape'],
    shown: 'Esc',
    does: 'Cancel the running work, hide a blend, close a message, or leave the presentation or the tour',
    run: stepBack,
  },
  openHelp: {
    keys: ['?'],
    shown: '?',
    does: 'This help',
    button: { in: 'end', testId: 'help', label: 'Help', icon: 'help' },
    run: ({ overlays }) => overlays.openHelp(),
  },
  cancel: { run: cancel },
  closeError: { run: closeError },
  reload: { run: ({ remembered }) => remembered.settle().then(() => location.reload()) },
  singleKeys: { run: ({ viewState }, singleKeys: boolean) => viewState.change({ singleKeys }) },
  planExport: { run: planExport },
  savePage: { run: (context) => runExport(context, { ...DEFAULT_REQUEST, page: true }) },
  export: { run: runExport },
  openEmbed: {
    run: async ({ exporting, overlays }) => overlays.openEmbed((await exporting.get()).snippet()),
  },
} satisfies Actions;

function historyButton(testId: 'undo' | 'redo', verb: string, step: (context: Context) => string | null): Button {
  const now = (context: Context) => {
    const what = step(context);
    const label = what ? `${verb}: ${what}` : `Nothing to ${testId}`;
    return { label, hint: label, disabled: what === null };
  };
  return { in: 'history', testId, label: verb, icon: testId, now };
}

/** The choice takes effect immediately. Its plan follows later. */
async function planExport({ viewState, exporting }: Context, chosen: ExportRequest): Promise<void> {
  const request = { ...chosen };
  viewState.changeOpened({ exporting: { request, plan: null } });
  (await exporting.get()).plan(request);
}

async function runExport({ exporting }: Context, request: ExportRequest): Promise<void> {
  await (await exporting.get()).run(request);
}

function cancel({ guide, exporting, animation, session }: Context): void {
  if (guide.now?.cancel()) return;
  exporting.now?.cancel();
  animation.now?.cancel();
  session.cancel();
}

function closeError({ viewState }: Context): void {
  viewState.change({ errorMessage: null });
}

/** Each press of Escape closes or cancels one thing: a dialog, a running task, or a mode. */
function stepBack(context: Context): void {
  const { viewState, session, guide, fileIntake } = context;
  const { working, errorMessage } = viewState.page;
  const { placing, blend, opening } = viewState.opened;
  if (placing) viewState.changeOpened({ placing: false });
  else if (working) cancel(context);
  else if (blend) showBlend(context, null);
  else if (errorMessage) closeError(context);
  else if (fileIntake.waits) fileIntake.forget();
  else if (opening) asked(context);
  else if (session.store.get().view.present) present(context, null);
  else void guide.now?.close();
}
