/** `codecs.js`: the libraries for compressed files in one file. */
export { codecs } from '../worker/codecs.ts';
