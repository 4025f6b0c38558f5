/** Memory of a process and its children, as reported by Linux. */
import { existsSync, readdirSync, readFileSync } from 'node:fs';

const statusOf = (id: string): string => {
  try {
    return readFileSync(`/proc/${id}/status`, 'utf8');
  } catch {
    return '';
  }
};

/** Peak resident set of this process in MB; NaN if the system does not report it. */
export function ownPeak(): number {
  return Number(/^VmHWM:\s+(\d+)/m.exec(statusOf('self'))?.[1] ?? Number.NaN) / 1024;
}

/** Peak and current resident sets in MB of all children of `pid`; null if the system does not report them. */
export function residentOf(pid: number): { peak: number; now: number }[] | null {
  if (!existsSync('/proc/self/status')) return null;
  const parentOf = new Map(
    readdirSync('/proc')
      .filter((id) => /^\d+$/.test(id))
      .map((id) => [Number(id), Number(/^PPid:\s+(\d+)/m.exec(statusOf(id))?.[1] ?? 0)]),
  );
  const isOurs = (id: number): boolean => id === pid || (id > 1 && isOurs(parentOf.get(id) ?? 0));
  return [...parentOf.keys()]
    .filter((id) => id !== pid && isOurs(id))
    .map((id) => {
      const status = statusOf(String(id));
      const of = (field: string): number =>
        Number(new RegExp(`^${field}:\\s+(\\d+)`, 'm').exec(status)?.[1] ?? 0) / 1024;
      return { peak: of('VmHWM'), now: of('VmRSS') };
    });
}
