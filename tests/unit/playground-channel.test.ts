/** Any page of the host can write to the channel, so only valid messages are accepted. */
import { expect, it } from 'vitest';
import { messageFrom } from '../../web/model/playground-channel.ts';

const passing = {
  times: [0, 1, 2],
  boundary: 'natural',
  startSpeed: 1,
  endSpeed: 1,
  tension: [0, 0, 0],
  bias: [0, 0, 0],
};
const shape = { ...passing, page: 'p', title: 't', coordinates: [{ name: 'n', unit: '°', values: [1, 2, 3] }] };

it.each([
  { type: 'ask' },
  { type: 'done', page: 'p' },
  { type: 'open', shape },
  { type: 'back', page: 'p', ...passing },
])('takes $type', (message) => {
  expect(messageFrom(message)).toEqual(message);
});

it.each([
  null,
  'ask',
  {},
  { type: 'nonsense' },
  { type: 'open' },
  { type: 'open', shape: { ...shape, coordinates: undefined } },
  { type: 'open', shape: { ...shape, coordinates: [{ name: 'n', unit: '°', values: [1, 2] }] } },
  { type: 'open', shape: { ...shape, coordinates: [{ name: 'n', unit: '°', values: [1, NaN, 3] }] } },
  { type: 'open', shape: { ...shape, coordinates: Array(1e5).fill(shape.coordinates[0]) } },
  { type: 'open', shape: { ...shape, title: 'x'.repeat(1e6) } },
  { type: 'open', shape: { ...shape, times: [0, 2, 1] } },
  { type: 'open', shape: { ...shape, tension: [0] } },
  { type: 'done', page: 1 },
  { type: 'back', ...passing },
  { type: 'back', page: 'p', ...passing, times: 7 },
  { type: 'back', page: 'p', ...passing, times: [] },
  { type: 'back', page: 'p', ...passing, boundary: 'evil' },
  { type: 'back', page: 'p', ...passing, startSpeed: '1' },
  { type: 'back', page: 'p', ...passing, bias: [0, 0, Infinity] },
])('takes nothing of %o', (message) => {
  expect(messageFrom(message)).toBeNull();
});
