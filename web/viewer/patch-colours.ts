/** Colours that distinguish patches, or regions. */

/**
 * One colour per patch; consecutive patches have very different hues. A vertex gets the colour of one of its faces.
 * Linear RGB.
 */
export function patchColours(patches: Int32Array, indices: Uint32Array, vertices: number): Float32Array {
  const colours = new Float32Array(3 * vertices).fill(0.2);
  patches.forEach((patch, face) => {
    if (patch < 0) return;
    const colour = hueColour(patch);
    for (let corner = 0; corner < 3; corner += 1) colours.set(colour, 3 * indices[3 * face + corner]!);
  });
  return colours;
}

/** The same colour in style sheets. */
export function patchColour(index: number): string {
  const { hue, lightness } = toneOf(index);
  return `hsl(${hue} ${100 * SATURATION}% ${100 * lightness}%)`;
}

const SATURATION = 0.45;

/**
 * The golden angle spreads any number of hues. Lightness and saturation vary, so consecutive colours also differ in
 * grey.
 */
function toneOf(index: number): { hue: number; lightness: number } {
  return { hue: (index * 137.508) % 360, lightness: 0.5 + 0.14 * ((index % 3) - 1) };
}

function hueColour(index: number): [number, number, number] {
  const { hue, lightness } = toneOf(index);
  const channel = (offset: number): number => {
    const k = (offset + hue / 30) % 12;
    const strength = SATURATION * Math.min(lightness, 1 - lightness);
    return (lightness - strength * Math.max(-1, Math.min(k - 3, 9 - k, 1))) ** 2.2;
  };
  return [channel(0), channel(8), channel(4)];
}
