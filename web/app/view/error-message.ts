/** Turns any failure into a sentence for users and a line for experts. */
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
  // A part of the page failed to load. Each browser has its own message for this.
  if (/dynamically imported module|module script failed/i.test(error.message))
    return {
      message: 'A part of this page could not be loaded. Check the connection and try again.',
      details: error.message,
      retry: true,
    };
  const details = parts.join(', ');
  return code === 'not-loaded' ? { message: error.message, details, retry: true } : { message: error.message, details };
}
