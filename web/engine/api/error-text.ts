/** A share of the diagonal as people read it. */
export function errorText(share: number): string {
  return `${Number((100 * share).toPrecision(2))} % of the diagonal`;
}
