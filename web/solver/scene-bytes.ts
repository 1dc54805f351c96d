/** Whether a host sends a scene file: some that have none send a page instead. */
export function isSceneFile(response: Response): boolean {
  return response.ok && !response.headers.get('content-type')?.startsWith('text/html');
}

/** Its bytes; null where it sends none. */
export async function sceneBytes(response: Response): Promise<ArrayBuffer | null> {
  return isSceneFile(response) ? response.arrayBuffer() : null;
}
