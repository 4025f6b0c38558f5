/** Samples made in the browser. The code is a thousandth of the files' size. */
import { column } from './column.ts';
import type { Sculpture } from './glb.ts';
import { glb } from './glb.ts';
import { meshOf } from './mesh.ts';
import type { Mesh } from './mesh.ts';
import { serpent } from './serpent.ts';
import { turret } from './turret.ts';

const SCULPTORS: Record<string, (detail: number) => Promise<Sculpture>> = { column, serpent, turret };

/** A sample as a GLB and as arrays; `detail` 1 is the shown shape, smaller values are coarser. */
export async function make(id: string, detail = 1): Promise<{ bytes: Uint8Array; mesh: Mesh }> {
  const sculptor = SCULPTORS[id];
  if (!sculptor) throw new Error(`There is no code that makes the sample ${id}.`);
  const sculpture = await sculptor(detail);
  return { bytes: glb(sculpture), mesh: meshOf(sculpture) };
}
