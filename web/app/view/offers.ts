/** Offers over the shape that the user accepts or declines. */
import { createOffer } from '../../ui/messages.ts';

export function createOffers() {
  const newVersion = createOffer('new-version');
  const notReopened = createOffer('not-reopened');
  const imported = createOffer('import-offer');
  const pose = createOffer('pose-offer');
  const all = [newVersion, notReopened, imported, pose];
  return {
    newVersion,
    notReopened,
    imported,
    pose,
    elements: all.map(({ element }) => element),
    withdraw: () => all.forEach(({ offer }) => offer(null)),
  };
}

export type Offers = ReturnType<typeof createOffers>;
