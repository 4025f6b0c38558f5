// Loaded before a program: at its end, its peak memory in bytes is written to file 3.
import { writeSync } from 'node:fs';

process.on('exit', () => writeSync(3, String(process.resourceUsage().maxRSS * 1024)));
