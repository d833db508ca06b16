// Serves a folder to this machine alone: node tools/serve_page.mjs FOLDER [PORT]. Port 0: any that is free.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { pathToFileURL } from "node:url";

const kinds = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm", ".png": "image/png" };

async function answer(folder, request, response) {
  const path = normalize(decodeURIComponent(new URL(request.url, "http://here").pathname));
  try {
    const name = path.endsWith("/") ? path + "index.html" : path;
    const bytes = await readFile(join(folder, name));
    response.writeHead(200, { "Content-Type": kinds[extname(name)] ?? "application/octet-stream" });
    response.end(bytes);
  } catch {
    response.writeHead(404);
    response.end("not here");
  }
}

// The server and its address, once it listens.
export function serve(folder, port) {
  return new Promise((listening, failed) => {
    const server = createServer((request, response) => answer(folder, request, response));
    server.on("error", failed);
    server.listen(port, "127.0.0.1", () => listening({ server, address: `http://127.0.0.1:${server.address().port}/` }));
  });
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [folder, port = "8000"] = process.argv.slice(2);
  try {
    const { address } = await serve(folder, Number(port));
    console.log(`The page is at ${address} until Ctrl+C.`);
  } catch (error) {
    console.error(`The page cannot be served at port ${port}: ${error.message}. Give another port.`);
    process.exit(1);
  }
}
