import { useEffect, useState } from 'preact/hooks';

/** So many entries are added at a time. */
const atOnce = 24;

/**
 * How many entries of a list are rendered: few at first, soon all. Between them the page goes on.
 *
 * @param what the list belongs to; another one begins anew
 */
export function useGrowing(length: number, what: object): number {
  const [grown, setGrown] = useState({ what, count: atOnce });
  const count = grown.what === what ? grown.count : atOnce;
  useEffect(() => {
    if (count >= length) return undefined;
    const timer = setTimeout(() => setGrown({ what, count: count + atOnce }));
    return () => clearTimeout(timer);
  }, [count, length, what]);
  return Math.min(count, length);
}
