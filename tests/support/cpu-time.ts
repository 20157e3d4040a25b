/**
 * Measures the processor time of an action in milliseconds. Unlike elapsed time it does not grow on
 * a busy machine, so a guard against hanging can be tight.
 */
export async function cpuTime(action: () => unknown): Promise<number> {
  const before = process.cpuUsage();
  await action();
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1000;
}
