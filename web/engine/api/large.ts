/** Vertices. Smaller shapes are made at once: neither a second thread nor a sketch is worth it. */
export const LARGE = 40_000;
