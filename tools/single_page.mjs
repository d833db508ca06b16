// Everything that a page fetches, in one HTML file: node tools/single_page.mjs FOLDER FILE. A page from file:// may fetch nothing,
// so the program and its files go in as text in base 64, squeezed by gzip, which every browser undoes by itself.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

const [folder, target] = process.argv.slice(2);
const read = (name) => readFileSync(join(folder, name));
const packed = (name) => gzipSync(read(name), { level: 9 }).toString("base64");
const inScript = (text) => text.replaceAll("</script", "<\\/script");

// Before the program starts: its parts are unpacked and handed over in place of fetching.
const unpack = `
window.knitPacked = (Module) => {
  const parts = { "knit-mesh.wasm": "${packed("knit-mesh.wasm")}", "knit-mesh.data": "${packed("knit-mesh.data")}" };
  window.knitUnpacked = Promise.all(Object.entries(parts).map(async ([name, text]) => {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return [name, await new Response(stream).arrayBuffer()];
  })).then(Object.fromEntries);
};`;
const start = `
window.knitUnpacked.then((parts) => {
  Module.wasmBinary = parts["knit-mesh.wasm"];
  Module.getPreloadedPackage = (name) => parts[name.slice(name.lastIndexOf("/") + 1)];
  const script = document.createElement("script");
  script.textContent = document.getElementById("program").textContent;
  document.body.append(script);
});`;

const html = read("index.html")
  .toString()
  .replace(/<script src="page.js"><\/script>/, () => `<script>${unpack}</script>\n<script>${inScript(read("page.js").toString())}</script>`)
  .replace(
    /<script src="knit-mesh.js"><\/script>/,
    () => `<script id="program" type="text/plain">${inScript(read("knit-mesh.js").toString())}</script>\n<script>${start}</script>`,
  );
writeFileSync(target, html);
