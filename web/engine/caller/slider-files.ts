/** Morph target weights as functions of one slider: a table, and drivers for Blender. */
import type { ExportedFile } from '../api/types.ts';
import type { PlannedFrames } from './export-source.ts';

/** A table cell, quoted so spreadsheets do not read a name as a formula. Without control characters. */
const cell = (name: string): string =>
  `"${name
    .replace(/\p{Cc}/gu, ' ')
    .replaceAll('"', '""')
    .replace(/^[=+@ -]/, "'$&")}"`;

/** A string in Python, with control characters as escapes. */
const pythonText = (name: string): string =>
  JSON.stringify(name).replace(/\p{Cc}/gu, (control) => `\\u${control.charCodeAt(0).toString(16).padStart(4, '0')}`);

function rowsOf({ principal }: PlannedFrames, count: number): number[][] {
  const { weights } = principal!;
  return Array.from({ length: weights.length / count }, (_, row) =>
    Array.from(weights.subarray(row * count, (row + 1) * count), (weight) => Number(weight.toPrecision(7))),
  );
}

function csv(names: readonly string[], times: readonly number[], rows: readonly number[][]): string {
  const lines = rows.map((row, index) => [times[index], ...row].join(','));
  return [['slider', ...names.map(cell)].join(','), ...lines, ''].join('\n');
}

function blenderScript(names: readonly string[], times: readonly number[], rows: readonly number[][]): string {
  const columns = names.map((name, k) => [name, rows.map((row) => row[k])] as const);
  return `# Blender: import the GLB, select its mesh, and run this script in the Text Editor. The object then has a custom property
# "slider" that drives all its shape keys.
import bpy

TIMES = ${JSON.stringify(times)}
WEIGHTS = {
${columns.map(([name, weights]) => `    ${pythonText(name)}: ${JSON.stringify(weights)},`).join('\n')}
}

shape = bpy.context.object
keys = shape.data.shape_keys
keys.animation_data_clear()
shape["slider"] = TIMES[0]
shape.id_properties_ui("slider").update(min=TIMES[0], max=TIMES[-1])
for name, weights in WEIGHTS.items():
    block = keys.key_blocks[name]
    block.slider_min = min(0.0, *weights)
    block.slider_max = max(1.0, *weights)
    curve = block.driver_add("value")
    for modifier in list(curve.modifiers):
        curve.modifiers.remove(modifier)
    curve.driver.type = "AVERAGE"
    variable = curve.driver.variables.new()
    variable.targets[0].id = shape
    variable.targets[0].data_path = '["slider"]'
    curve.keyframe_points.add(len(TIMES))
    for point, time, weight in zip(curve.keyframe_points, TIMES, weights):
        point.co = (time, weight)
        point.interpolation = "LINEAR"
    curve.update()
`;
}

export function sliderFiles(stem: string, names: readonly string[], frames: PlannedFrames): ExportedFile[] {
  const rows = rowsOf(frames, names.length);
  const file = (name: string, text: string): ExportedFile => ({ name, bytes: new TextEncoder().encode(text) });
  return [
    file(`${stem}.csv`, csv(names, frames.times, rows)),
    file(`${stem}.py`, blenderScript(names, frames.times, rows)),
  ];
}
