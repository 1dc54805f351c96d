// No C++ function of more than 50 lines of code. clang-tidy (readability-function-size) finds the functions; its
// count holds blank lines and comments too, so they are taken off here. A file without a pair of braces that far
// apart cannot hold such a function and is not handed to clang-tidy, which takes seconds for what includes Eigen.
import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import path from 'node:path';

/** Lines of code from the one after a function's opening brace to its closing one; .clang-tidy says the same. */
export const MOST_LINES = 50;

const FOLDERS = ['core', 'precompute', 'wasm', 'tests'];
const CONTAINER = /\bnamespace\b[^()]*$|\b(?:class|struct|union|enum)\b[^()=]*$|\bextern\s*""\s*$/;
const TOKEN =
  /\/\/[^\n]*|\/\*[\s\S]*?\*\/|R"([^(\s]*)\([\s\S]*?\)\1"|"(?:[^"\\\n]|\\.)*"|(?<![0-9A-Fa-f])'(?:[^'\\\n]|\\.)*'/g;

/** Comments become blanks; texts keep their quotes alone, so that no brace in them counts. Lines stay where they are. */
export function bareCode(source) {
  return source.replace(TOKEN, (token) => {
    const lines = token.split('\n');
    if (token.startsWith('/')) return lines.map(() => '').join('\n');
    return lines.map((line, i) => (i === 0 || i === lines.length - 1 ? '""' : '"')).join('\n');
  });
}

/** Every pair of braces in the order of the opening one: its lines (from 0), its lines of code, and whether it holds
 * declarations (a namespace, a class) rather than statements. */
export function bracePairs(source) {
  const code = bareCode(source);
  const lines = code.split('\n').map((line) => line.trim() !== '');
  const open = [];
  const pairs = [];
  let line = 0;
  let since = 0; // where the words before the next brace begin
  for (let i = 0; i < code.length; ++i) {
    const c = code[i];
    if (c === '\n') ++line;
    if (c === '{') {
      const pair = { begin: line, end: line, container: CONTAINER.test(code.slice(since, i)) };
      pairs.push(pair);
      open.push(pair);
    }
    if (c === '}' && open.length > 0) {
      const pair = open.pop();
      pair.end = line;
      pair.lines = lines.slice(pair.begin + 1, pair.end + 1).filter(Boolean).length;
    }
    if (c === '{' || c === '}' || c === ';') since = i + 1;
  }
  return pairs;
}

/** Whether the file may hold a function that clang-tidy finds too long. */
export const mayBeLong = (source) =>
  bracePairs(source).some((pair) => !pair.container && pair.end - pair.begin > MOST_LINES);

/** What clang-tidy found in one file: [{ name, line (from 0), height (with blanks and comments) }]. */
export function longFunctions(output, file) {
  const found = [];
  for (const text of output.split('\n')) {
    const at = /^(.*?):(\d+):\d+: (warning|note|error): (.*)$/.exec(text);
    if (!at || path.resolve(at[1]) !== path.resolve(file)) continue;
    const name = /^function '(.*)' exceeds recommended size/.exec(at[4]);
    const height = /^(\d+) lines including whitespace and comments/.exec(at[4]);
    if (name) found.push({ name: name[1], line: Number(at[2]) - 1, height: 0 });
    if (height && found.length > 0) found.at(-1).height = Number(height[1]);
  }
  return found;
}

/** Lines of code of a function that clang-tidy found at `line`, `height` lines from brace to brace. */
export function codeLines(source, { line, height }) {
  const body = bracePairs(source).find((pair) => pair.begin >= line && pair.end - pair.begin === height);
  return body ? body.lines : height;
}

function sourcesBelow(root, folder) {
  return readdirSync(path.join(root, folder), { recursive: true, encoding: 'utf8' })
    .filter((name) => /\.(cpp|h)$/.test(name))
    .map((name) => path.join(folder, name))
    .sort();
}

function tidy(root, file) {
  return new Promise((resolve) => {
    const args = ['-p', 'build/native', '--quiet', '--header-filter', `/${file}$`, file];
    const child = spawn('clang-tidy', args, { cwd: root });
    let output = '';
    child.stdout.on('data', (data) => (output += data));
    child.stderr.on('data', (data) => (output += data));
    child.on('error', (error) => resolve({ output: error.message, failed: true }));
    child.on('close', (status) => resolve({ output, failed: status !== 0 && / error: /.test(output) }));
  });
}

/** { passed, failed, complaints }: files, and a line for each function that is too long or file that is not understood. */
export async function checkFunctionSizes(root) {
  const rules = readFileSync(path.join(root, '.clang-tidy'));
  const stamp = path.join(root, 'build', 'stamps', 'function-sizes.json');
  const known = existsSync(stamp) ? JSON.parse(readFileSync(stamp, 'utf8')) : {};
  const files = FOLDERS.flatMap((folder) => sourcesBelow(root, folder));
  const good = {};
  const complaints = [];
  const asked = [];
  for (const file of files) {
    const source = readFileSync(path.join(root, file), 'utf8');
    const key = createHash('sha256').update(rules).update(source).digest('hex');
    if (known[file] === key || !mayBeLong(source)) good[file] = key;
    else asked.push({ file, source, key });
  }
  const check = async ({ file, source, key }) => {
    const { output, failed } = await tidy(root, file);
    const tooLong = longFunctions(output, path.join(root, file))
      .map((one) => ({ ...one, lines: codeLines(source, one) }))
      .filter((one) => one.lines > MOST_LINES);
    for (const { name, line, lines } of tooLong)
      complaints.push(`${file}:${line + 1}: ${name} has ${lines} lines of code; at most ${MOST_LINES}`);
    if (failed) complaints.push(`${file}: clang-tidy does not understand it\n${output.slice(0, 2000)}`);
    if (!failed && tooLong.length === 0) good[file] = key;
  };
  const workers = cpus().map(async () => {
    while (asked.length > 0) await check(asked.shift());
  });
  await Promise.all(workers);
  mkdirSync(path.dirname(stamp), { recursive: true });
  writeFileSync(stamp, JSON.stringify(good));
  const passed = Object.keys(good).length;
  return { passed, failed: files.length - passed, complaints: complaints.sort() };
}
