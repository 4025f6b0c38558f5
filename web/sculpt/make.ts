/** Samples that are made where they are shown: their formulas are a thousandth of their files. */
import { column } from './column.ts';
import type { Sculpture } from './glb.ts';
import { glb } from './glb.ts';
import { serpent } from './serpent.ts';
import { turret } from './turret.ts';

const SCULPTORS: Record<string, (detail: number) => Promise<Sculpture>> = { column, serpent, turret };

/** A GLB; `detail` 1 is what is shown, less is coarser. */
export async function make(id: string, detail = 1): Promise<Uint8Array> {
  const sculptor = SCULPTORS[id];
  if (!sculptor) throw new Error(`Nothing is known of how ${id} is made.`);
  return glb(await sculptor(detail));
}
