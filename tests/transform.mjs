import { transformSync } from 'rolldown/utils';

export default {
  process(code, file) {
    const result = transformSync(file, code, {
      sourcemap: true,
      target: 'es2022',
      jsx: { runtime: 'automatic', importSource: 'preact' },
    });
    if (result.errors.length > 0) throw new Error(result.errors.map((error) => error.message).join('\n'));
    return { code: result.code, map: JSON.stringify(result.map) };
  },
};
