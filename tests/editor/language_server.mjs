// Drives a real yaml-language-server over stdio and checks what an editor shows with docs/nsv.schema.json.
//
//     npm install yaml-language-server@1.25.0 --prefix /tmp/yls
//     node tests/editor/language_server.mjs /tmp/yls/node_modules/.bin/yaml-language-server
import { spawn } from "node:child_process";
import assert from "node:assert/strict";
import { fileURLToPath, pathToFileURL } from "node:url";
import path from "node:path";

const repository = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const schema = pathToFileURL(path.join(repository, "docs/nsv.schema.json")).href;
const server = spawn(process.argv[2] ?? "yaml-language-server", ["--stdio"], { stdio: ["pipe", "pipe", "inherit"] });
const waiting = new Map();
const published = [];
let buffer = Buffer.alloc(0);
let last = 0;

function send(message) {
  const text = JSON.stringify({ jsonrpc: "2.0", ...message });
  server.stdin.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
}
function request(method, params) {
  const id = ++last;
  send({ id, method, params });
  return new Promise((resolve) => waiting.set(id, resolve));
}
function receive(message) {
  if (message.method === "textDocument/publishDiagnostics") published.push(message.params);
  else if (message.method === "workspace/configuration") send({ id: message.id, result: message.params.items.map(() => null) });
  else if (message.method && message.id !== undefined) send({ id: message.id, result: null });
  else if (waiting.has(message.id)) waiting.get(message.id)(message.result);
}
server.stdout.on("data", (data) => {
  buffer = Buffer.concat([buffer, data]);
  for (;;) {
    const head = buffer.indexOf("\r\n\r\n");
    if (head < 0) return;
    const length = Number(/Content-Length: (\d+)/i.exec(buffer.subarray(0, head).toString())[1]);
    if (buffer.length < head + 4 + length) return;
    receive(JSON.parse(buffer.subarray(head + 4, head + 4 + length).toString()));
    buffer = buffer.subarray(head + 4 + length);
  }
});
const limit = setTimeout(() => { console.error("the language server does not answer"); process.exit(1); }, 60_000);

await request("initialize", { processId: process.pid, rootUri: null, capabilities: { textDocument: { completion: { completionItem: { documentationFormat: ["markdown"] } } } } });
send({ method: "initialized", params: {} });

let documents = 0;
function open(lines) {
  const uri = `file:///spec${++documents}.yaml`;
  // The line that docs/composition.md names: no setting of the editor is needed.
  const text = [`# yaml-language-server: $schema=${schema}`, ...lines].join("\n");
  send({ method: "textDocument/didOpen", params: { textDocument: { uri, languageId: "yaml", version: 1, text } } });
  return uri;
}
const at = (uri, line, character) => ({ textDocument: { uri }, position: { line, character } });
async function labels(lines, line, character) {
  const result = await request("textDocument/completion", at(open(lines), line, character));
  return result.items.map((item) => item.label);
}

const keys = await labels(["nsv: 1", "controller:", "  "], 3, 2);
for (const key of ["sample_time", "norm", "barrier_margin", "blocks"]) assert.ok(keys.includes(key), `${key} in ${keys}`);

const words = await labels(["nsv: 1", "controller:", "  norm: "], 3, 8);
for (const word of ["frobenius", "spectral"]) assert.ok(words.includes(word), `${word} in ${words}`);

const gains = await labels(["controller:", "  blocks:", "    speed:", "      "], 4, 6);
for (const gain of ["K", "kbar", "constraint"]) assert.ok(gains.includes(gain), `${gain} in ${gains}`);

const spec = open(["nsv: 1", "controller:", "  barrier_margin: 1e-3", "scenario: {horizon: 5 s}"]);
const hover = JSON.stringify((await request("textDocument/hover", at(spec, 3, 5)))?.contents);
for (const part of ["clamped", "rad", "1e-3"]) assert.ok(hover.includes(part), `${part} in ${hover}`);
const horizon = JSON.stringify((await request("textDocument/hover", at(spec, 4, 13)))?.contents);
assert.ok(horizon.includes("length of a run") && horizon.includes("20 s"), horizon);

const wrong = open(["nsv: 1", "name: a", "controler: 1"]);
while (!published.some((one) => one.uri === wrong)) await new Promise((resolve) => setTimeout(resolve, 50));
const faults = JSON.stringify(published.filter((one) => one.uri === wrong));
assert.ok(faults.includes("controler") && faults.includes("plant"), faults);

clearTimeout(limit);
console.log("completion, hover and faults of the schema work in yaml-language-server");
server.kill();
