/** What the first script may have to say. note: apart from it, for it waits for no words. */
export async function sentences() {
  const { words } = await import('../../language/language.ts');
  return words.value.opening;
}
