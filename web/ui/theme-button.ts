/** The button that cycles through system, light and dark colours. */
import { button, tooltip } from './controls.ts';
import { setAttribute } from './dom.ts';
import type { IconName } from './icons.ts';
import { setIcon } from './icons.ts';
import type { Theme } from './theme.ts';

const THEMES: Record<Theme, { icon: IconName; label: string }> = {
  system: { icon: 'system', label: 'System colours' },
  light: { icon: 'light', label: 'Light colours' },
  dark: { icon: 'dark', label: 'Dark colours' },
};

export function createThemeButton(
  onTheme: () => void,
  shortcut?: string,
): { element: HTMLButtonElement; update(theme: Theme): void } {
  const element = button({ label: 'Colours', testId: 'theme', icon: 'system', shortcut, onClick: onTheme });
  return {
    element,
    update(theme) {
      setIcon(element, THEMES[theme].icon);
      const words = `${THEMES[theme].label}; click to change`;
      setAttribute(element, 'aria-label', words);
      setAttribute(element, 'title', tooltip(words, shortcut));
      setAttribute(element, 'data-theme-choice', theme);
    },
  };
}
