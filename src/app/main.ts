import '../ui/styles/page.css';
import '../ui/styles/view.css';
import '../ui/styles/elements.css';
import '../ui/styles/panels.css';
import '../ui/styles/timeline.css';
import '../ui/styles/status.css';
import '../ui/styles/controls.css';
import '../ui/styles/screens.css';
import { start } from './start.ts';

void start(document.getElementById('app')!);
