/** What can be done at once about what an import warns of: an offer over the viewport, gone with the next files. */
import type { Offer } from '../../ui/messages.ts';
import type { OpenedFiles, OpenFiles } from '../sources/open-files.ts';

/** null where there is nothing to be done. */
export function importOffer({ info, orientation }: OpenedFiles, files: OpenFiles): Offer | null {
  const message = (code: string): string | undefined => info.warnings.find((warning) => warning.code === code)?.message;
  const same = message('same-poses');
  if (same && info.animations.length > 0)
    return { message: same, action: 'Use the animation', onAccept: () => void files.takeAnimation() };
  if (same) return { message: same };
  const lying = message('z-up');
  if (lying && orientation)
    return {
      message: lying,
      action: 'Stand it up',
      onAccept: () => void files.reorient({ ...orientation, up: 'z' }),
    };
  return null;
}
