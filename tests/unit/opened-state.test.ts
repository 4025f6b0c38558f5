/** What is shown first of what was opened. */
import { expect, it } from 'vitest';
import { ofFiles } from '../../web/app/sources/opened-state.ts';
import { docOfKeys, keyRef } from './documents.ts';

const animations = [
  { name: 'walk', start: 0, end: 2, keys: 49, moves: true },
  { name: 'nod', start: 0, end: 1, keys: 4, moves: true },
];
const hold = (keys: number, animation: number, project: object | null = null): string =>
  ofFiles(docOfKeys(...Array.from({ length: keys }, (_, i) => keyRef(i, `${i}`, i))), {
    animation,
    animations,
    project,
  }).motion.hold;

it('moments of an animation are held where they rest; poses, projects and two keys are not', () => {
  expect([hold(8, 0), hold(8, 1), hold(3, 0)]).toEqual(['contact', 'contact', 'contact']);
  // An animation of morph targets whose keys are these poses, poses without any, a project, and two moments.
  expect([hold(4, 1), hold(8, -1), hold(8, 0, {}), hold(2, 0)]).toEqual(['off', 'off', 'off', 'off']);
});
