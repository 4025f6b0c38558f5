/** Values other than the default, for every row of the table of <shape-spline>. */
import type { Row } from '../web/embed/attributes.ts';

export function samples(row: Row): unknown[] {
  switch (row.kind) {
    case 'text':
      return [row.sample ?? 'words of it'];
    case 'flag':
      return [true];
    case 'number':
      return [Math.min(row.max, 7)];
    case 'numbers':
      return [[0.5, 2]];
    case 'words':
      return [[...row.choices]];
    case 'choice':
      return [...row.choices];
  }
}
