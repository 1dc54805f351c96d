/** The bytes of a scene file as a host sends them; null where it has no such file (some hosts send a page instead). */
export async function sceneBytes(response: Response): Promise<ArrayBuffer | null> {
  const isPage = response.headers.get('content-type')?.startsWith('text/html') ?? false;
  return response.ok && !isPage ? response.arrayBuffer() : null;
}
