/** Light or dark: the system's choice unless the user has made one, stored only on this machine. */
import { readSetting, writeSetting } from './local-setting.ts';

export type Theme = 'system' | 'light' | 'dark';

const KEY = 'shapespline.theme';
const NEXT: Record<Theme, Theme> = { system: 'light', light: 'dark', dark: 'system' };

export interface ThemeSwitch {
  theme(): Theme;
  isDark(): boolean;
  next(): void;
}

export function createTheme(onChange: () => void): ThemeSwitch {
  const system = window.matchMedia('(prefers-color-scheme: dark)');
  let theme = remembered();
  const apply = (): void => {
    document.documentElement.style.colorScheme = theme === 'system' ? 'light dark' : theme;
    onChange();
  };
  system.addEventListener('change', onChange);
  document.documentElement.style.colorScheme = theme === 'system' ? 'light dark' : theme;
  return {
    theme: () => theme,
    isDark: () => (theme === 'system' ? system.matches : theme === 'dark'),
    next() {
      theme = NEXT[theme];
      writeSetting(KEY, theme === 'system' ? null : theme);
      apply();
    },
  };
}

function remembered(): Theme {
  const value = readSetting(KEY);
  return value === 'light' || value === 'dark' ? value : 'system';
}
