// wasi.mjs: runs a WebAssembly program under node:  node --no-warnings wasi.mjs PROGRAM.wasm ARGUMENTS
import { readFileSync } from 'node:fs';
import { WASI } from 'node:wasi';
const [, , program, ...rest] = process.argv;
const wasi = new WASI({ version: 'preview1', args: [program, ...rest] });
const { instance } = await WebAssembly.instantiate(readFileSync(program), wasi.getImportObject());
process.exitCode = wasi.start(instance);
