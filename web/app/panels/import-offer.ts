/** An offer over the viewport: actions for the files just opened. The next files remove it. */
import type { Offer } from '../../ui/messages.ts';
import { isClosed } from '../sources/closed-motion.ts';
import type { OpenResult, Opener } from '../sources/opener.ts';

/** The offer for opened files; null without a suitable action. `onLoop` makes the motion periodic. */
export function importOffer(opened: OpenResult, files: Opener, onLoop: () => void): Offer | null {
  const { info, orientation, source, doc, pool } = opened;
  const message = (code: string): string | undefined => info.warnings.find((warning) => warning.code === code)?.message;
  const same = message('same-poses');
  if (same && info.animations.length > 0)
    return { message: same, action: 'Use the animation', onAccept: () => void files.takeAnimation() };
  if (same) return { message: same };
  if (opened.stoodUp && orientation)
    return {
      message: 'The files do not state the up axis. Z is used.',
      action: 'Lay it back',
      onAccept: () => void files.reorient({ ...orientation, up: 'y' }),
    };
  if (orientation?.up === 'y' && message('z-up-unclear'))
    return {
      message: 'The files do not state the up axis. If the shape lies on its back, stand it up.',
      action: 'Stand it up',
      onAccept: () => void files.reorient({ ...orientation, up: 'z' }),
    };
  const open = source.kind === 'files' && doc.motion.boundary === 'natural';
  if (open && isClosed(doc, pool))
    return { message: 'The last pose is the same as the first.', action: 'Make it a loop', onAccept: onLoop };
  return null;
}
