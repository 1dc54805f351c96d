// The length of a C++ function: what counts as a line of code, and which files need clang-tidy at all.
import {
  MOST_LINES,
  bareCode,
  bracePairs,
  codeLines,
  longFunctions,
  mayBeLong,
} from '../../scripts/function-sizes.mjs';

const statements = (count) => '  f();\n'.repeat(count);
const functionOf = (count) => `void g() {\n${statements(count)}}\n`;

test('no brace in a comment or a text counts', () => {
  const source = [
    'void f() { // {',
    '  /* {',
    "     { */ g(\"{\", '{', 1'000);",
    '  h(R"x({ ")" \' {',
    '})x");',
    '}',
  ].join('\n');
  expect(bareCode(source).match(/[{}]/g)).toEqual(['{', '}']);
  expect(bareCode(source).split('\n')).toHaveLength(6);
  expect(bracePairs(source)).toMatchObject([{ begin: 0, end: 5, lines: 4, container: false }]);
});

test('blank lines and comments are no code', () => {
  const source = 'int f()\n{\n  // why\n\n  /* two\n     lines */\n  return 1;  // one\n}\n';
  expect(codeLines(source, { line: 0, height: 6 })).toBe(2);
});

test('a function is found behind the braces of its arguments', () => {
  const source = `void f(std::vector<int> a = {}) {\n${statements(3)}}\n`;
  expect(codeLines(source, { line: 0, height: 4 })).toBe(4);
});

test('only files with braces far enough apart go to clang-tidy', () => {
  expect(mayBeLong(functionOf(MOST_LINES - 1))).toBe(false);
  expect(mayBeLong(functionOf(MOST_LINES))).toBe(true);
  expect(mayBeLong(`class A : B<int> {\n${functionOf(30)}${functionOf(30)}};\n`)).toBe(false);
  expect(mayBeLong(`namespace {\n${functionOf(30)}${functionOf(30)}}\n`)).toBe(false);
  expect(mayBeLong(`template <class T>\nstruct A {\n${functionOf(60)}};\n`)).toBe(true);
  expect(mayBeLong(`template <class T>\nT f(T t) {\n${statements(60)}}\n`)).toBe(true);
});

test('the words of clang-tidy are understood', () => {
  const output = [
    "/p/a.cpp:7:13: warning: function 'f' exceeds recommended size/complexity thresholds [readability-function-size]",
    'void f() {',
    '     ^',
    '/p/a.cpp:7:13: note: 81 lines including whitespace and comments (threshold 50)',
    "/p/a.h:3:13: warning: function 'g' exceeds recommended size/complexity thresholds [readability-function-size]",
    '/p/a.h:3:13: note: 90 lines including whitespace and comments (threshold 50)',
  ].join('\n');
  expect(longFunctions(output, '/p/a.cpp')).toEqual([{ name: 'f', line: 6, height: 81 }]);
});
