/** Samples made in the browser: their formulas are a thousandth of the size of their files. */
import { column } from './column.ts';
import type { Sculpture } from './glb.ts';
import { glb } from './glb.ts';
import { meshOf } from './mesh.ts';
import type { Mesh } from './mesh.ts';
import { serpent } from './serpent.ts';
import { turret } from './turret.ts';

const SCULPTORS: Record<string, (detail: number) => Promise<Sculpture>> = { column, serpent, turret };

/** As a GLB and as its arrays; `detail` 1 is the shown shape, less is coarser. */
export async function make(id: string, detail = 1): Promise<{ bytes: Uint8Array; mesh: Mesh }> {
  const sculptor = SCULPTORS[id];
  if (!sculptor) throw new Error(`Nothing is known of how ${id} is made.`);
  const sculpture = await sculptor(detail);
  return { bytes: glb(sculpture), mesh: meshOf(sculpture) };
}
