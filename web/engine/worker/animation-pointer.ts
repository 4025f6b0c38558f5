/** KHR_animation_pointer for glTF-Transform, which would drop it. Writes the targets of all channels unchanged. */
import type { Extension, GLTF, ReaderContext, WriterContext } from '@gltf-transform/core';
import type { Codecs } from './codecs.ts';

type Core = Awaited<ReturnType<Codecs['core']>>;

const NAME = 'KHR_animation_pointer';

/** The extension's class, derived from the loaded library. */
export function animationPointer({ Extension: Base }: Pick<Core, 'Extension'>): typeof Extension {
  return class AnimationPointer extends Base {
    static override readonly EXTENSION_NAME = NAME;
    override readonly extensionName = NAME;
    /** The targets per animation and channel. */
    #targets: GLTF.IAnimationChannelTarget[][] = [];

    override read({ jsonDoc }: ReaderContext): this {
      this.#targets = (jsonDoc.json.animations ?? []).map(({ channels }) => channels.map(({ target }) => target));
      return this;
    }

    override write({ jsonDoc }: WriterContext): this {
      for (const [index, { channels }] of (jsonDoc.json.animations ?? []).entries())
        for (const [c, channel] of channels.entries())
          if (channel.target.path === ('pointer' as never)) channel.target = this.#targets[index]![c]!;
      return this;
    }
  } as unknown as typeof Extension;
}
