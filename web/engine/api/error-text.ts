/** Formats a share of the diagonal for users. */
export function errorText(share: number): string {
  return `${Number((100 * share).toPrecision(2))} % of the model's size`;
}
