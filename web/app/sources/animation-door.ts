/** The way to what is done with the animation of a file, which is loaded when somebody asks for it. */
import type { Animation, AnimationParts } from './animation.ts';

export function createAnimationDoor(parts: AnimationParts): Animation {
  let animation: Animation | null = null;
  const load = async (): Promise<Animation> => {
    const { createAnimation } = await import('./animation.ts');
    animation ??= createAnimation(parts);
    return animation;
  };
  return {
    takeFewest: async (of, percent) => (await load()).takeFewest(of, percent),
    reference: async () => (await load()).reference(),
    takeTruth: async (picked) => (await load()).takeTruth(picked),
    dropTruth: () => animation?.dropTruth(),
    get truth() {
      return animation?.truth ?? null;
    },
    cancel: () => animation?.cancel(),
  };
}
