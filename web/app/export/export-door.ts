/** The way to exports, which are loaded when somebody asks for one. */
import type { ExportController, ExportParts } from './export-controller.ts';

export function createExportDoor(parts: ExportParts): ExportController {
  let controller: ExportController | null = null;
  const load = async (): Promise<ExportController> => {
    const { createExportController } = await import('./export-controller.ts');
    controller ??= createExportController(parts);
    return controller;
  };
  return {
    plan: (request) => void load().then((loaded) => loaded.plan(request), parts.onError),
    run: (request) => load().then((loaded) => loaded.run(request), parts.onError),
    snippet: () => load().then((loaded) => loaded.snippet()),
    cancel: () => controller?.cancel(),
  };
}
