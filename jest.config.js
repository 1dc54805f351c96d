// TypeScript by the compiler that Vite itself uses; Wasm and ES modules as they are shipped.
export default {
  testEnvironment: 'node',
  maxWorkers: '100%', // of the cores; Jest alone would leave one idle
  testTimeout: 60_000, // a busy machine is no fault
  testMatch: ['<rootDir>/tests/{web,wasm,rooms,scripts}/**/*.test.{ts,tsx,mjs}'],
  extensionsToTreatAsEsm: ['.ts', '.tsx'],
  transform: { '\\.tsx?$': '<rootDir>/tests/transform.mjs' },
};
