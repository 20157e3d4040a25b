import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { readFigure } from '../meeting/figure.ts';
import { type Design, motionJson } from './curves.ts';
import { dogWag } from './dog-wag.ts';
import { withFeetDown } from './feet-down.ts';
import { humanIdle } from './human-idle.ts';
import { humanWalk } from './human-walk.ts';
import { humanWave } from './human-wave.ts';
import { withFeetPlanted } from './planted-foot.ts';

/** Makes the motions of the human and the dog, as MOTION.json, from their bundled files. */
export async function makeMotions(dataFolder: string): Promise<void> {
  const human = await readFigure(dataFolder, 'human');
  const planted = withFeetPlanted(humanWalk, human.character);
  const walk = await withFeetDown(planted, human.character);
  const idle = await withFeetDown(humanIdle, human.character);
  write(join(dataFolder, 'human'), { walk, wave: humanWave, idle });
  write(join(dataFolder, 'dog'), { 'tail-wag': dogWag });
}

function write(folder: string, designs: Readonly<Record<string, Design>>): void {
  for (const [name, design] of Object.entries(designs)) {
    const { channels, ...head } = motionJson(design);
    const rows = channels.map((channel) => `  ${JSON.stringify(channel)}`).join(',\n');
    const text = `${JSON.stringify(head).slice(0, -1)},"channels":[\n${rows}\n]}\n`;
    writeFileSync(join(folder, `${name}.motion.json`), text);
  }
}
