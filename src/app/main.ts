import '../ui/style.css';
import { start } from './start.ts';

void start(document.getElementById('app')!);
