// node node.mjs PROGRAM.wasm.gz < CASES.json > TOLD.json: the page's program without a page.
import fs from 'node:fs';
import zlib from 'node:zlib';
const cases = JSON.parse(fs.readFileSync(0, 'utf8'));
const { instance: { exports } } = await WebAssembly.instantiate(zlib.gunzipSync(fs.readFileSync(process.argv[2])), {});
const call = (run, text) => {
  const bytes = new TextEncoder().encode(text);
  const at = exports.room(bytes.length);
  new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
  const length = run();
  return new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.place(), length));
};
const told = cases.map(({ opening, answers }) => {
  const fault = call(exports.open, JSON.stringify(opening));
  return fault === 'null' ? JSON.parse(call(exports.ask, JSON.stringify({ check: answers }))) : fault;
});
fs.writeFileSync(1, JSON.stringify(told));
