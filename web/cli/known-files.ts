/** Files that a command reads or that its inputs refer to. Outputs do not replace them, whatever their names. */
import { stat } from 'node:fs/promises';
import { EngineError } from '../engine/api/errors.ts';

/** Identifies a file by device and inode, because links and letter case give it several names; null without a file. */
export async function identityOf(file: string): Promise<string | null> {
  const there = await stat(file, { bigint: true }).catch(() => null);
  return there && `${there.dev}:${there.ino}`;
}

export class KnownFiles {
  /** Their names, and for companions the input that refers to them. */
  private readonly files = new Map<string, { name: string; of: string | null }>();

  /** `overwrite`: whether an output may replace an input, but not a companion. */
  constructor(private readonly overwrite = false) {}

  async add(name: string, of: string | null = null): Promise<void> {
    const identity = await identityOf(name);
    if (identity !== null && (of !== null || !this.files.has(identity))) this.files.set(identity, { name, of });
  }

  /** Refuses to write `file`. `flag`: the option that names the file; null for files that are written beside it. */
  async check(file: string, shown: string, flag: string | null): Promise<void> {
    const known = this.files.get((await identityOf(file)) ?? '');
    if (!known || (flag && known.of === null && this.overwrite)) return;
    const { name, of } = known;
    const what = of === null ? 'is one of the inputs' : `belongs to the input ${of}`;
    const same = name === shown ? '' : ` (as ${name})`;
    const remedy = flag && of === null ? ', or add --overwrite to replace it' : '';
    throw new EngineError(
      'would-overwrite',
      `${shown} ${what}${same} and would be lost. Give ${flag ?? '--output'} another name${remedy}.`,
      { file: shown },
    );
  }
}
