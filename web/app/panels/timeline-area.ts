/** The area below the shape: keys, timeline, transport, status line and warnings. */
import type { AppState } from '../../model/state.ts';
import { endTangents, referenceKey } from '../../model/state.ts';
import { phaseOf, timeScale } from '../../model/time-scale.ts';
import type { Phase } from '../../model/time-scale.ts';
import type { Speeds } from '../../model/speeds.ts';
import { createClockMenu } from '../../ui/clock-menu.ts';
import type { ClockMenuProps } from '../../ui/clock-menu.ts';
import { createKeyStrip } from '../../ui/key-strip.ts';
import type { KeyItem, KeyStrip, KeyStripProps } from '../../ui/key-strip.ts';
import { lazyComponent } from '../../ui/lazy.ts';
import type { LazyComponent } from '../../ui/lazy.ts';
import { createStatusLine } from '../../ui/status-line.ts';
import { createTimeline } from '../../ui/timeline.ts';
import type { Timeline, TimelineProps } from '../../ui/timeline.ts';
import { createTransport } from '../../ui/transport.ts';
import type { WarningsList, WarningsProps } from '../../ui/warnings.ts';
import { addReason } from '../actions/keys.ts';
import type { Commands } from '../actions/table.ts';
import { warningItems } from '../drawing/marking.ts';
import { PLAYING_TOLERANCE } from '../drawing/scene-controller.ts';
import type { OpenedState } from '../view/view-state.ts';
import { latest } from './connect.ts';
import type { Connect, Shown } from './connect.ts';

export interface TimelineArea {
  keyStrip: KeyStrip;
  timeline: Timeline;
  transport: HTMLElement;
  warnings: HTMLElement;
  status: HTMLElement;
  toggleClock(): void;
}

export function createTimelineArea(
  commands: Commands,
  connect: Connect,
  onError: (error: unknown) => void,
): TimelineArea {
  const keyStrip = createKeyStrip({
    onSeek: commands.seek,
    onMove: commands.moveKey,
    onRemove: commands.removeKey,
    onRetime: commands.retimeKey,
    onRename: commands.renameKey,
    onShaping: commands.shaping,
    onTiming: commands.timing,
    onTurns: commands.turns,
    onComponent: commands.component,
    onReference: commands.reference,
    onAddCurrent: () => void commands.addCurrent(),
    onAddFile: commands.pickKeys,
    onError,
  });
  connect(keyStrip, keyStripProps);
  const warnings: LazyComponent<WarningsProps, WarningsList> = lazyComponent(async () => {
    const { createWarnings } = await import('../../ui/warnings.ts');
    return createWarnings(commands.markWarning);
  }, onError);
  connect(warnings, ({ opened }) => ({ items: itemsOf(opened.warnings), shown: opened.shownWarning }));
  const status = createStatusLine((from) => void warnings.need().then((list) => list?.toggle(from)));
  return {
    keyStrip,
    ...createTime(commands, connect),
    warnings: warnings.element,
    status: connect(status, ({ state, opened, page }) => ({
      keys: state.doc.keys.length,
      vertices: opened.info?.report.vertices ?? 0,
      faces: opened.info?.report.faces ?? 0,
      ms: opened.ms,
      warnings: opened.warnings.length,
      offline: page.offline,
    })),
  };
}

function createTime(
  commands: Commands,
  connect: Connect,
): Pick<TimelineArea, 'timeline' | 'transport' | 'toggleClock'> {
  const timeline = createTimeline({
    onSeek: commands.seek,
    onRetime: commands.retimeKey,
    onBetween: commands.between,
    onWindow: commands.window,
    onSpeed: commands.endSpeed,
    onPeek: commands.peek,
  });
  const clockMenu = createClockMenu({
    onFps: commands.fps,
    onLoopEnd: commands.loopEnd,
    onBetween: commands.between,
    onZoom: commands.zoomTime,
    onWindow: commands.window,
  });
  const transport = createTransport(connect(timeline, timelineProps), connect(clockMenu, clockProps), {
    onTogglePlay: commands.togglePlay,
    onLoop: commands.loop,
    onSpeed: commands.speed,
    onSeek: commands.goTo,
  });
  const element = connect(transport, ({ state: { play, time, doc }, range, disabled }) => ({
    play,
    time,
    range,
    periodic: doc.motion.boundary === 'periodic',
    disabled,
  }));
  return { timeline, transport: element, toggleClock: clockMenu.toggle };
}

/** Phase of the current time: at, between or beyond the keys. */
export function shownPhase({ state: { doc, play, time }, range }: Shown): Phase {
  const tolerance = play.playing ? PLAYING_TOLERANCE : undefined;
  return phaseOf({ t: time, keys: doc.keys, range, periodic: doc.motion.boundary === 'periodic', tolerance });
}

/** The speeds at Hermite ends; null for other ends. */
export function endSpeeds({ state: { doc }, disabled }: Shown): Speeds | null {
  const { boundary, startSpeed: start, endSpeed: end } = doc.motion;
  return boundary === 'hermite' && !disabled ? { start, end } : null;
}

function timelineProps(shown: Shown): TimelineProps {
  const { state, opened, range, disabled } = shown;
  const { doc, play, time, view } = state;
  return {
    ...timeScale(range, doc.keys.length),
    keys: doc.keys,
    time,
    playing: play.playing,
    phase: shownPhase(shown),
    periodic: doc.motion.boundary === 'periodic',
    disabled,
    fps: play.fps,
    between: play.between,
    window: view.window,
    speeds: endSpeeds(shown),
    maxSpeeds: opened.maxSpeeds,
    towards: endTangents(doc),
    speedCurve: disabled ? null : opened.speedCurve,
    picture: opened.timePicture,
  };
}

function clockProps({ state: { doc, play, time, view }, opened: { info }, range, disabled }: Shown): ClockMenuProps {
  const { fps, between } = play;
  return { ...timeScale(range, doc.keys.length), time, fps, between, window: view.window, info, disabled };
}

function keyStripProps({ state, opened, range, disabled }: Shown): KeyStripProps {
  const { doc, time } = state;
  return {
    keys: keyItems(doc, opened.thumbnails),
    owner: state.source.kind === 'sample' ? state.source.id : state.project,
    time,
    range,
    disabled,
    canRemove: doc.keys.length > 2,
    components: opened.stats?.components ?? 1,
    motion: doc.motion,
    addReason: addReason(doc.keys, time),
  };
}

// Returns the same list until its content changes, so strip and warnings are not redrawn on every frame.
const itemsOf = latest(warningItems);
const keyItems = latest((doc: AppState['doc'], thumbnails: OpenedState['thumbnails']): KeyItem[] => {
  const reference = referenceKey(doc);
  return doc.keys.map((key, index) => ({
    ...key,
    isReference: index === reference,
    thumbnail: thumbnails.get(key.pose) ?? null,
  }));
});
