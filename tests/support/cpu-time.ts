/**
 * Milliseconds of processor time that something took: other than by the clock, a busy machine does
 * not make it longer, so that a guard against hanging can be near.
 */
export async function cpuTime(action: () => unknown): Promise<number> {
  const before = process.cpuUsage();
  await action();
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1000;
}
