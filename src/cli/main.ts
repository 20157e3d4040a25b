import { commands } from './commands.ts';
import { UsageError } from './usage-error.ts';

const helpWords: readonly string[] = ['--help', '-h'];

/** Returns the exit code: 0 on success, 1 for a file that can't be used, 2 for wrong usage. */
async function main(words: readonly string[]): Promise<number> {
  const [name, ...rest] = words;
  const command = commands.find((candidate) => candidate.name === name);
  const usage = commands.map((each) => `  sinew ${each.usage}`).join('\n');
  // Everybody may ask for help, in the ways that are usual.
  if (words.some((word) => helpWords.includes(word)) || name === 'help') {
    const named = command ?? commands.find((each) => each.name === rest[0]);
    const help = (named ? [named] : commands).map(
      (each) => `  sinew ${each.usage}\n      ${each.summary}`,
    );
    console.log(`Usage:\n${help.join('\n')}`);
    return 0;
  }
  try {
    if (!command) throw new UsageError(`expected a command, found "${name ?? ''}"`);
    return await command.run(rest);
  } catch (error) {
    if (!(error instanceof UsageError)) throw error;
    console.error(`${error.message}\nUsage:\n${command ? `  sinew ${command.usage}` : usage}`);
    return 2;
  }
}

process.exitCode = await main(process.argv.slice(2));
