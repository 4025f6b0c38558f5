/** The playground's entry point. */
import { registerServiceWorker } from '../offline/register.ts';
import { createThemeButton } from '../ui/theme-button.ts';
import { createOffer } from '../ui/messages.ts';
import { createTheme } from '../ui/theme.ts';
import { createPlayPage } from './page.ts';
import { createAppConnection } from './app-connection.ts';

const reducedMotion = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
const newVersion = createOffer('new-version');
const problem = createOffer('problem');
const theme = createTheme(() => themeButton.update(theme.theme()));
const themeButton = createThemeButton(() => theme.next());
const appConnection = createAppConnection({
  get: () => page.get(),
  change: (state) => page.change(state, 'natural'),
});
const page = createPlayPage({
  notices: [newVersion.element, problem.element],
  appConnection,
  theme: themeButton.element,
  playing: !reducedMotion,
  onError: (error) => problem.offer({ message: error instanceof Error ? error.message : String(error) }),
  onIgnoredValues: (message) => problem.offer(message === null ? null : { message }),
});
themeButton.update(theme.theme());
// Inside another page, the playground leaves out parts that this page has.
if (window !== window.parent) document.documentElement.dataset['framed'] = '';
document.getElementById('play')?.replaceChildren(page.element);
registerServiceWorker({
  onNewVersion(reload) {
    newVersion.offer({ message: 'A new version of this page is ready.', action: 'Reload', onAccept: reload });
  },
  onRepaired: (message) => problem.offer({ message }),
});
