import { Failure } from '../core/failure.ts';
import { defaultLimits } from '../core/limits.ts';
import type { LooseFile } from '../workers/read-characters-task.ts';

/**
 * Fetches a file from the page's own server and unpacks it if it is gzipped. Before and after
 * unpacking, it may have at most as many bytes as a dropped file; beyond that, no more bytes are
 * requested.
 */
export async function fetchFile(
  url: URL,
  signal?: AbortSignal,
  limit = defaultLimits.fileSize,
): Promise<LooseFile> {
  // Sinew opens nothing from other servers, nor from object URLs.
  if (!url.href.startsWith(`${location.origin}/`)) {
    throw new Failure(
      `${url.href} is not a file of this page's own server; download it and drop it here`,
    );
  }
  const response = await fetchChecked(url, signal);
  const fetched = await collect(response.body!, url, limit);
  const path = decodeURIComponent(url.pathname.slice(url.pathname.lastIndexOf('/') + 1));
  // Some servers unpack .gz files in transit, so this tests the bytes instead of the name.
  const isPacked = fetched[0] === 0x1f && fetched[1] === 0x8b;
  return {
    path: path.replace(/\.gz$/i, ''),
    bytes: isPacked ? await collect(gunzip(fetched), url, limit) : fetched,
  };
}

/** Fetches from the page's own server only; a redirect fails. */
export async function fetchChecked(url: URL, signal?: AbortSignal): Promise<Response> {
  let response: Response;
  try {
    // The mode is that of what the page requests early, which would be requested twice otherwise.
    response = await fetch(url, { mode: 'cors', redirect: 'error', ...(signal && { signal }) });
  } catch {
    throw new Failure(`${url.pathname} could not be fetched`);
  }
  if (!response.ok) throw new Failure(`${url.pathname}: the server says ${response.status}`);
  return response;
}

function gunzip(bytes: Uint8Array<ArrayBuffer>): ReadableStream<Uint8Array<ArrayBuffer>> {
  return new Response(bytes).body!.pipeThrough(new DecompressionStream('gzip'));
}

/** Reads all bytes of a stream, and cancels it if there are more than the limit. */
async function collect(
  stream: ReadableStream<Uint8Array<ArrayBuffer>>,
  { pathname }: URL,
  limit: number,
): Promise<Uint8Array<ArrayBuffer>> {
  const reader = stream.getReader();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  try {
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      size += part.value.length;
      if (size > limit) break;
      parts.push(part.value);
    }
  } catch {
    throw new Failure(`${pathname} broke off, or is damaged`);
  }
  if (size > limit) {
    reader.cancel().catch(() => undefined); // a failure to cancel does not matter
    throw new Failure(`${pathname} has more than ${limit} bytes`);
  }
  const bytes = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}
