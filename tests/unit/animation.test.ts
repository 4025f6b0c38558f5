/** The animation in the open files. */
import { expect, it, vi } from 'vitest';
import { docOfKeys } from './documents.ts';
import { Animation, type AnimationParts } from '../../web/app/sources/animation.ts';

it('searches for the fewest keys leave no listener behind', async () => {
  const parts = {
    workspace: { info: null, options: {} },
    store: { get: () => ({ doc: docOfKeys() }) },
    onWorking: () => 0,
  };
  const animation = new Animation(parts as unknown as AnimationParts);
  const listen = vi.spyOn(AbortSignal.prototype, 'addEventListener');
  for (let i = 0; i < 3; ++i) expect(await animation.takeFewest(0, 1)).toBeNull();
  expect(listen).not.toHaveBeenCalled();
});
