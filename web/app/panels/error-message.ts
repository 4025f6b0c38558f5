/** Any failure as a sentence for people and a line for experts. */
import type { ErrorMessage } from '../../ui/messages.ts';

export function errorMessageOf(error: unknown): ErrorMessage {
  if (!(error instanceof Error))
    return { message: 'Something went wrong. The shape on the screen is still usable.', details: String(error) };
  const { code, place } = error as { code?: unknown; place?: unknown };
  const places = Object.entries(typeof place === 'object' && place !== null ? place : {});
  const parts = [
    typeof code === 'string' ? `code ${code}` : error.name,
    ...places.map(([name, value]) => `${name} ${String(value)}`),
  ];
  if (places.some(([, value]) => typeof value === 'number')) parts.push('counted from 0');
  if (error.cause instanceof Error) parts.push(error.cause.message);
  return { message: error.message, details: parts.join(', ') };
}
