/** Name of the animation that keys were taken from. */
import type { KeysInfo } from './types.ts';

/** Named by its index, because the file has no name. */
const UNNAMED = /^(animation \d+)?$/;

/** null without an animation, or for one without a name. A project keeps the name of its animation. */
export function clipName(info: Pick<KeysInfo, 'animation' | 'animations' | 'project' | 'objects'>): string | null {
  const { animation, animations, project, objects } = info;
  const name = animations[animation < 0 && project !== null ? 0 : animation]?.name ?? '';
  // Without a name, an export names its animation like its mesh.
  const isOwn = project === null || name !== objects[0];
  return isOwn && !UNNAMED.test(name) ? name : null;
}
