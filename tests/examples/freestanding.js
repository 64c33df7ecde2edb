// Runs the WebAssembly module that freestanding.c makes: node freestanding.js freestanding.wasm
const { high, low } = new WebAssembly.Instance(new WebAssembly.Module(require('fs').readFileSync(process.argv[2]))).exports;
console.log([high(), low()].map(part => (part >>> 0).toString(16).padStart(8, '0')).join(''));
