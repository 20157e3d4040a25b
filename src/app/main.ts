import '../ui/styles/page.css';
import '../ui/styles/view.css';
import '../ui/styles/elements.css';
import '../ui/styles/panels.css';
import '../ui/styles/timeline.css';
import '../ui/styles/bars.css';
import '../ui/styles/dialog.css';
import '../ui/styles/palette.css';
import '../ui/styles/gallery.css';
import '../ui/styles/arrival.css';
import '../ui/styles/controls.css';
import '../ui/styles/screens.css';
import { failureText } from '../ui/attempt.ts';
import { start } from './start.ts';

const root = document.getElementById('app')!;
start(root).catch((error: unknown) => {
  const message = document.createElement('p');
  message.className = 'message';
  message.setAttribute('role', 'alert');
  message.textContent = failureText(error);
  (root.querySelector('.overlay') ?? root).append(message);
});
