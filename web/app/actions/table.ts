/** All commands, in the order of the help and of the buttons. */
import type { Bound } from './action.ts';
import { COMPARISON } from './comparison.ts';
import { FILES } from './files.ts';
import { KEYS } from './keys.ts';
import { MOTION } from './motion.ts';
import { PAGE } from './page.ts';
import { SHAPE } from './shape.ts';
import { TIME } from './time.ts';
import { VIEW } from './view.ts';

export const ACTIONS = { ...TIME, ...KEYS, ...MOTION, ...SHAPE, ...VIEW, ...COMPARISON, ...FILES, ...PAGE };

export type Commands = Bound<typeof ACTIONS>;
