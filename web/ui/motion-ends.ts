/** The ends of the motion: the boundary and its options. */
import { hasEffect } from '../engine/api/rules.ts';
import { keyChoices } from '../model/key-names.ts';
import type { End, Speeds } from '../model/speeds.ts';
import { SPEED_NAME, TANGENT_NAME } from '../model/speeds.ts';
import type { Encoding, Motion } from '../model/state.ts';
import type { Component } from './dom.ts';
import { group } from './dom.ts';
import type { DropPoint } from './file-drop.ts';
import { optionControl, optionField } from './option-field.ts';
import type { OptionProps } from './option-field.ts';

const ENDS = ['start', 'end'] as const;
const NEIGHBOURS: Record<End, string> = { start: 'the next key', end: 'the key before' };

/** A value that no pose has. */
const FROM_FILE = 'file';

export interface MotionEndsProps extends OptionProps {
  /** The largest offered end speeds. */
  maxSpeeds: Speeds;
  /** Name of any opened pose, including poses that are not keys. */
  poseName: (pose: number) => string;
  /** The default period, for the field's placeholder. */
  period: number;
}

export interface MotionEndsEvents {
  onMotion(change: Partial<Motion>): void;
  onSpeed(end: End, speed: number): void;
  onEncoding(change: Partial<Encoding>): void;
  /** Lets the user choose a file for the end tangent. */
  onTangentFile(end: End): void;
}

export interface MotionEnds extends Component<MotionEndsProps> {
  /** The end whose tangent field is at this point of the page, or null. */
  endAt(at: DropPoint): End | null;
}

export function createMotionEnds(events: MotionEndsEvents): MotionEnds {
  const tangents = ENDS.map((end) => createTangent(end, events));
  const ease = group<MotionEndsProps>([...ENDS.map((end) => createSpeed(end, events)), ...tangents], ({ motion }) =>
    hasEffect('startSpeed', motion),
  );
  const period = group<MotionEndsProps>([createPeriod(events)], ({ motion }) => hasEffect('period', motion));
  return {
    ...group([optionField('boundary', events.onMotion), ease, period], undefined, 'rows'),
    endAt({ x, y }) {
      const [under] = document.elementsFromPoint(x, y).filter((one) => ease.element.contains(one));
      return ENDS.find((_, index) => under && tangents[index]!.element.contains(under)) ?? null;
    },
  };
}

function createSpeed(end: End, { onSpeed }: MotionEndsEvents): Component<MotionEndsProps> {
  const name = SPEED_NAME[end];
  return optionField(
    name,
    ({ [name]: speed }) => onSpeed(end, speed!),
    ({ maxSpeeds }) => ({ reach: maxSpeeds[end] }),
  );
}

function createPeriod({ onMotion }: MotionEndsEvents): Component<MotionEndsProps> {
  let shortest = 0;
  return optionField<MotionEndsProps>(
    'period',
    onMotion,
    ({ motion, keys, period }) => {
      shortest = Number(((keys.at(-1)?.time ?? 0) - (keys[0]?.time ?? 0)).toFixed(4));
      return { text: String(Number((motion.period ?? period).toFixed(4))) };
    },
    {
      validationError: (value) =>
        value > shortest ? null : `longer than the time from the first key to the last, ${shortest} s`,
    },
  );
}

/** The end tangent's shape: the neighbour, another key, or one from a file. */
function createTangent(end: End, { onEncoding, onTangentFile }: MotionEndsEvents): Component<MotionEndsProps> {
  const name = TANGENT_NAME[end];
  let shown: number | null = null;
  const field = optionControl(`${end}Tangent`, (value: string) => {
    if (value !== FROM_FILE) return onEncoding({ [name]: value === '' ? null : Number(value) });
    // The displayed choice stays unchanged until a shape is chosen.
    field.update(shown, {});
    onTangentFile(end);
  });
  return {
    element: field.element,
    update({ keys, encoding, poseName }) {
      const pose = encoding[name];
      const other = pose !== null && keys.every((key) => key.pose !== pose);
      shown = pose;
      field.update(pose, {
        choices: [
          { value: '', label: NEIGHBOURS[end] },
          ...keyChoices(keys),
          ...(other ? [{ value: String(pose), label: poseName(pose) }] : []),
          { value: FROM_FILE, label: 'a shape from a file…' },
        ],
      });
    },
  };
}
