/** Overlays of the page: dialogs, loaded on first use, and file choosers. */
import type { InsertPosition } from '../../model/edits.ts';
import { playRange } from '../../model/frames.ts';
import type { End } from '../../model/speeds.ts';
import type { EmbedDialog } from '../../ui/embed-dialog.ts';
import type { ExportDialog } from '../../ui/export-dialog.ts';
import type { ExportDialogProps } from '../../ui/export-fields.ts';
import { createDropZone, createPicker } from '../../ui/file-drop.ts';
import type { DropPoint } from '../../ui/file-drop.ts';
import type { Help } from '../../ui/help.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import type { LinkDialog } from '../../ui/link-dialog.ts';
import type { MotionPanel } from './sidebar.ts';
import type { Overlays } from '../actions/context.ts';
import type { Commands } from '../actions/table.ts';
import type { Connect, Shown } from './connect.ts';
import type { TimelineArea } from './timeline-area.ts';
import { SHORTCUTS } from './keyboard.ts';

type Dialogs = Pick<Overlays, 'openExport' | 'openEmbed' | 'openHelp' | 'openLink'> & { elements: HTMLElement[] };
type Choosers = Pick<Overlays, 'pickFiles' | 'pickKeys' | 'pickTangent' | 'pickReference'> & {
  elements: HTMLElement[];
};

export function createDialogs(commands: Commands, connect: Connect, onError: (error: unknown) => void): Dialogs {
  const exporting = lazyComponent<ExportDialogProps, ExportDialog>(async () => {
    const { createExportDialog } = await import('../../ui/export-dialog.ts');
    return createExportDialog({
      onChange: (request) => void commands.planExport(request),
      onExport: (request) => void commands.export(request),
      onEmbed: () => void commands.openEmbed(),
    });
  }, onError);
  const help = lazyComponent<boolean, Help>(async () => {
    const { createHelp } = await import('../../ui/help.ts');
    return createHelp(SHORTCUTS, commands.singleKeys);
  }, onError);
  const link = lazyComponent<void, LinkDialog>(async () => {
    const { createLinkDialog } = await import('../../ui/link-dialog.ts');
    return createLinkDialog(() => void commands.copyLink());
  }, onError);
  const embed = lazyComponent<void, EmbedDialog>(async () => {
    const { createEmbedDialog } = await import('../../ui/embed-dialog.ts');
    return createEmbedDialog({ onSave: () => void commands.savePage(), onError });
  }, onError);
  return {
    elements: [
      connect(exporting, exportProps),
      connect(help, ({ page }) => page.singleKeys),
      link.element,
      embed.element,
    ],
    openExport: () => void exporting.need().then((dialog) => dialog?.open()),
    openHelp: () => void help.need().then((dialog) => dialog?.open()),
    openLink: (to) => void link.need().then((dialog) => dialog?.open(to)),
    openEmbed: (snippet) => void embed.need().then((dialog) => dialog?.open(snippet)),
  };
}

function exportProps({ state: { play, source }, opened, page, range }: Shown): ExportDialogProps {
  return {
    ...opened.exporting,
    source,
    info: opened.info,
    range: playRange(play.between, range),
    fps: play.fps,
    speed: play.speed,
    videoFormats: page.videoFormats,
  };
}

export function createChoosers(
  commands: Commands,
  { keyStrip, timeline }: Pick<TimelineArea, 'keyStrip' | 'timeline'>,
  motionPanel: MotionPanel,
): Choosers {
  const insertPosition = (at: DropPoint): InsertPosition | null => {
    const [before, time] = [keyStrip.placeAt(at), timeline.timeAt(at)];
    if (before !== null) return { before };
    return time === null ? null : { time };
  };
  const files = createPicker('file-input', (picked) => void commands.take(picked));
  const keys = createPicker('key-file-input', (picked) => void commands.addKeys(picked));
  let tangentOf: End = 'start';
  const tangent = createPicker('tangent-file-input', (picked) => void commands.takeTangent(picked, tangentOf));
  const reference = createPicker('truth-file-input', (picked) => void commands.compareWith(picked));
  const dropZone = createDropZone(
    (dropped, at) => {
      if (takesReference(at)) return void commands.compareWith(dropped);
      const end = motionPanel.endAt(at);
      void (end ? commands.takeTangent(dropped, end) : commands.take(dropped, insertPosition(at)));
    },
    (at) => {
      const place = at && insertPosition(at);
      const before = place && 'before' in place ? place.before : null;
      keyStrip.showPlace(before);
      if (before !== null) return `A pose of this mesh becomes key ${before + 1}`;
      if (place && 'time' in place) return `A pose of this mesh becomes a key at ${Number(place.time.toFixed(3))} s`;
      if (at && takesReference(at)) return 'An animation of this mesh is compared with the motion';
      const end = at && motionPanel.endAt(at);
      return end && `A pose of this mesh sets the ${end} tangent`;
    },
  );
  return {
    elements: [dropZone.element, files.element, keys.element, tangent.element, reference.element],
    pickFiles: files.open,
    pickKeys: keys.open,
    pickTangent(end) {
      tangentOf = end;
      tangent.open();
    },
    pickReference: reference.open,
  };
}

function takesReference({ x, y }: DropPoint): boolean {
  return document.elementsFromPoint(x, y).some((one) => one.closest('[data-takes="truth"]'));
}
