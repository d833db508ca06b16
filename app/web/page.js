// The page around the program: arguments from the address, events to the canvas, files in and out, what the browser keeps.
// page_calls.h and the EM_JS lines of app/web name what both sides call.
"use strict";

const storage = "/home/web_user"; // the program's HOME, kept by the browser
const element = (id) => document.getElementById(id);

// The words of a command line: quotes hold together, a backslash takes the next character as it is.
function wordsOf(text) {
  const words = [];
  let word = null;
  let quote = "";
  for (let i = 0; i < text.length; ++i) {
    const c = text[i];
    if (quote) {
      if (c === quote) quote = "";
      else word += c;
    } else if (c === "'" || c === '"') {
      quote = c;
      word ??= "";
    } else if (c === " ") {
      if (word !== null) words.push(word);
      word = null;
    } else {
      word = (word ?? "") + (c === "\\" && i + 1 < text.length ? text[++i] : c);
    }
  }
  if (word !== null) words.push(word);
  return words;
}

function wordsOfAddress() {
  let text = location.hash.slice(1);
  try {
    text = decodeURIComponent(text);
  } catch {
    // taken as it stands
  }
  return wordsOf(text);
}

const asked = wordsOfAddress();
const embedded = asked.includes("--embed");
const given = [...asked];
if (given.every((word) => word === "--embed")) given.push("--example", "thesis-sphere");
document.body.classList.toggle("embedded", embedded);

// --- Downloads ---------------------------------------------------------------------------------------------------

const crcTable = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
  return n >>> 0;
});

function crcOf(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = crcTable[(crc ^ byte) & 255] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

// Files [{name, bytes}] as one zip, stored as they are.
function zipOf(files) {
  const parts = [];
  const entries = [];
  let offset = 0;
  const u16 = (...values) => values.flatMap((v) => [v & 255, (v >>> 8) & 255]);
  const u32 = (...values) => values.flatMap((v) => u16(v & 0xffff, v >>> 16));
  for (const { name, bytes } of files) {
    const title = new TextEncoder().encode(name);
    const about = [...u16(20, 0x800, 0, 0, 33), ...u32(crcOf(bytes), bytes.length, bytes.length), ...u16(title.length, 0)];
    parts.push(Uint8Array.from([...u32(0x04034b50), ...about]), title, bytes);
    entries.push(Uint8Array.from([...u32(0x02014b50), ...u16(20), ...about, ...u16(0, 0, 0), ...u32(0, offset)]), title);
    offset += 30 + title.length + bytes.length;
  }
  const size = entries.reduce((sum, part) => sum + part.length, 0);
  const end = Uint8Array.from([...u32(0x06054b50), ...u16(0, 0, files.length, files.length), ...u32(size, offset), ...u16(0)]);
  return new Blob([...parts, ...entries, end], { type: "application/zip" });
}

function download(name, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  ++knit.marks.downloads;
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

const outgoing = new Map();
let sending = 0;

function sendOutgoing() {
  sending = 0;
  const files = [...outgoing].map(([name, bytes]) => ({ name, bytes }));
  outgoing.clear();
  if (files.length === 1) download(files[0].name, new Blob([files[0].bytes]));
  else if (files.length > 1) download("knit-mesh.zip", zipOf(files));
}

// --- What the program calls --------------------------------------------------------------------------------------

const said = [];
let handle = 0; // the window
let running = 0; // the run in it
let lostCanvas = false;
let keeping = 0;

function keep() {
  clearTimeout(keeping);
  keeping = setTimeout(() => FS.syncfs(false, (error) => error && console.warn("not kept: " + error)), 100);
}

const knit = {
  marks: { started: false, frames: 0, firstFrame: 0, downloads: 0, ended: false },
  wordsOf,
  zipOf,
  open(window) {
    if (lostCanvas) {
      // A lost context stays its canvas's; a new canvas gets a new one.
      const old = Module.canvas;
      const fresh = old.cloneNode();
      old.replaceWith(fresh);
      Module.canvas = fresh;
      listen(fresh);
      lostCanvas = false;
    }
    handle = window;
  },
  close(window) {
    if (handle === window) handle = 0;
  },
  width: () => Module.canvas.clientWidth,
  height: () => Module.canvas.clientHeight,
  fit(width, height) {
    const canvas = Module.canvas;
    if (canvas.width === width && canvas.height === height) return;
    canvas.width = width;
    canvas.height = height;
    if (handle) Module._knit_refresh(handle);
  },
  // A command line of the program's is an address here.
  copy(text) {
    const link = text.startsWith("knit-mesh ")
      ? location.href.split("#")[0] + "#" + encodeURI(text.slice("knit-mesh ".length)).replace(/#/g, "%23")
      : text;
    knit.copied = link;
    navigator.clipboard?.writeText(link).catch(() => {});
  },
  written(path) {
    if (path.startsWith(storage + "/")) return keep();
    if (path.startsWith("/dropped/") || path.startsWith("/tmp/")) return;
    outgoing.set(path.slice(path.lastIndexOf("/") + 1), FS.readFile(path));
    clearTimeout(sending);
    sending = setTimeout(sendOutgoing, 200);
  },
  wanted() {
    element("picker").click();
  },
  started(run) {
    knit.marks.started = true;
    running = run;
  },
  // Where a control of that name stood in the last frame: [x, y, width, height]; null: nowhere.
  place(control) {
    const into = Module._malloc(16);
    let box = null;
    withText((name) => {
      if (running && Module._knit_place(running, name, into)) box = [...Module.HEAPF32.subarray(into >> 2, (into >> 2) + 4)];
    }, control);
    Module._free(into);
    return box;
  },
  drawn() {
    if (knit.marks.frames++ > 0) return;
    knit.marks.firstFrame = performance.now();
    element("veil").hidden = true;
    if (!embedded) Module.canvas.focus();
  },
  ended() {
    knit.marks.ended = true;
    running = 0;
    tell(said.join("\n") || "The program has ended. Load the page again to begin anew.");
  },
};

function tell(text) {
  knit.told = text;
  element("veil").hidden = false;
  element("progress").hidden = true;
  element("words").textContent = text;
}

// --- Hands and keyboard ------------------------------------------------------------------------------------------

const withText = (call, ...texts) => {
  const memory = texts.map((text) => {
    const length = lengthBytesUTF8(text) + 1;
    const at = Module._malloc(length);
    stringToUTF8(text, at, length);
    return at;
  });
  call(...memory);
  memory.forEach((at) => Module._free(at));
};

const modsOf = (event) => (event.shiftKey ? 1 : 0) | (event.ctrlKey ? 2 : 0) | (event.altKey ? 4 : 0) | (event.metaKey ? 8 : 0);
const buttonOf = [0, 2, 1, 3, 4]; // the browser's left, middle, right

// The browser's own: tabs, windows, reload, zoom, its tools; paste comes as an event of its own.
function browsersOwn(event) {
  if (["F5", "F11", "F12"].includes(event.key)) return true;
  if (!event.ctrlKey && !event.metaKey) return false;
  const key = event.key.toLowerCase();
  return ["w", "n", "t", "r", "l", "v", "tab", "0"].includes(key) || (event.shiftKey && ["i", "j", "c", "p"].includes(key));
}

function onKey(event) {
  if (!handle || event.isComposing) return;
  const down = event.type === "keydown";
  if (browsersOwn(event)) return;
  event.preventDefault();
  if (down && event.repeat && event.key.length !== 1 && event.key !== "Backspace") return;
  withText((code, key) => Module._knit_key(handle, code, key, down ? 1 : 0, modsOf(event)), event.code, event.key);
  const writes = down && [...event.key].length === 1 && ((!event.ctrlKey && !event.metaKey) || event.getModifierState("AltGraph"));
  if (writes) Module._knit_text(handle, event.key.codePointAt(0));
}

function onPaste(event) {
  if (!handle) return;
  const text = event.clipboardData.getData("text/plain");
  withText((at) => Module._knit_paste(handle, at), text);
  withText(
    (code, key) => {
      Module._knit_key(handle, code, key, 1, 2);
      Module._knit_key(handle, code, key, 0, 2);
    },
    "KeyV",
    "v",
  );
  event.preventDefault();
}

// One finger is the left button, held still for a while the right one, two zoom and move.
const fingers = new Map();
let touch = { held: 0, pressed: false, span: 0, timer: 0, from: null };

const placeOf = (event) => {
  const box = Module.canvas.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
};
const middleOf = () => {
  const all = [...fingers.values()];
  return [0, 1].map((i) => all.reduce((sum, place) => sum + place[i], 0) / all.length);
};
const spanOf = () => {
  const [a, b] = [...fingers.values()];
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
};
function press(button, down) {
  Module._knit_button(handle, button, down ? 1 : 0);
}
function letGo() {
  clearTimeout(touch.timer);
  if (touch.pressed) press(touch.button, false);
  touch.pressed = false;
}

function onTouch(event) {
  const place = placeOf(event);
  if (event.type === "pointerdown") {
    fingers.set(event.pointerId, place);
    letGo();
    if (fingers.size === 1) {
      touch.from = place;
      Module._knit_move(handle, ...place);
      touch.timer = setTimeout(() => {
        touch.from = null;
        press(1, true);
        press(1, false);
      }, 550);
    } else if (fingers.size === 2) {
      touch.from = null;
      touch.span = spanOf();
      Module._knit_move(handle, ...middleOf());
      press(1, true);
      Object.assign(touch, { pressed: true, button: 1 });
    }
    return;
  }
  if (!fingers.has(event.pointerId)) return;
  if (event.type === "pointermove") {
    fingers.set(event.pointerId, place);
    if (fingers.size === 2) {
      const span = spanOf();
      Module._knit_move(handle, ...middleOf());
      const turns = Math.log(span / Math.max(touch.span, 1)) / Math.log(1.1);
      if (Math.abs(turns) > 0.1) {
        Module._knit_wheel(handle, 0, turns);
        touch.span = span;
      }
    } else if (touch.from && Math.hypot(place[0] - touch.from[0], place[1] - touch.from[1]) > 6) {
      clearTimeout(touch.timer);
      touch.from = null;
      press(0, true);
      Object.assign(touch, { pressed: true, button: 0 });
      Module._knit_move(handle, ...place);
    } else if (touch.pressed) {
      Module._knit_move(handle, ...place);
    }
    return;
  }
  fingers.delete(event.pointerId);
  if (touch.from) {
    press(0, true); // a tap
    press(0, false);
    touch.from = null;
  }
  letGo();
}

function onPointer(event) {
  if (!handle) return;
  if (event.type === "pointerdown") {
    Module.canvas.focus();
    Module.canvas.setPointerCapture(event.pointerId);
  }
  if (event.pointerType === "touch") return onTouch(event);
  if (event.type === "pointerleave") return Module._knit_leave(handle);
  Module._knit_move(handle, ...placeOf(event));
  if (event.type === "pointerdown" || event.type === "pointerup") press(buttonOf[event.button] ?? -1, event.type === "pointerdown");
}

// In a course page the wheel is the page's until somebody clicks here.
function onWheel(event) {
  if (!handle || (embedded && document.activeElement !== Module.canvas)) return;
  event.preventDefault();
  const notch = event.deltaMode === 0 ? 100 : 3;
  Module._knit_wheel(handle, -event.deltaX / notch, -event.deltaY / notch);
}

async function takeFiles(files) {
  FS.mkdirTree("/dropped");
  for (const file of files) {
    const path = "/dropped/" + file.name.replaceAll("/", "_");
    FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
    if (handle) withText((at) => Module._knit_drop(handle, at), path);
  }
}

function listen(canvas) {
  for (const kind of ["pointerdown", "pointerup", "pointermove", "pointerleave", "pointercancel"]) canvas.addEventListener(kind, onPointer);
  canvas.addEventListener("wheel", onWheel, { passive: false });
  canvas.addEventListener("keydown", onKey);
  canvas.addEventListener("keyup", onKey);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("focus", () => handle && Module._knit_focus(handle, 1));
  canvas.addEventListener("blur", () => handle && Module._knit_focus(handle, 0));
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    lostCanvas = true;
    if (handle) Module._knit_lost(handle);
  });
}

listen(element("canvas"));
document.addEventListener("paste", onPaste);
document.addEventListener("dragover", (event) => event.preventDefault());
document.addEventListener("drop", (event) => {
  event.preventDefault();
  takeFiles(event.dataTransfer.files);
});
element("picker").addEventListener("change", (event) => {
  takeFiles(event.target.files);
  event.target.value = "";
});
addEventListener("hashchange", () => location.reload());

// --- The program -------------------------------------------------------------------------------------------------

function mountStorage() {
  FS.mkdirTree(storage);
  FS.mkdirTree("/work");
  FS.chdir("/work");
  try {
    FS.mount(IDBFS, {}, storage);
  } catch {
    return;
  }
  addRunDependency("storage");
  FS.syncfs(true, (error) => {
    if (error) console.warn("nothing is kept: " + error);
    removeRunDependency("storage");
  });
}

var Module = {
  knit,
  canvas: element("canvas"),
  arguments: given,
  thisProgram: "/knit-mesh", // its assets lie beside it
  preRun: [mountStorage],
  print: (text) => {
    said.push(text);
    console.log(text);
  },
  printErr: (text) => {
    said.push(text);
    console.info(text);
  },
  setStatus(text) {
    const share = /\((\d+)\/(\d+)\)/.exec(text);
    if (!share) return;
    element("progress").max = Number(share[2]);
    element("progress").value = Number(share[1]);
  },
  postRun: [
    () => {
      if (!knit.marks.started) tell(said.join("\n") || "There is nothing to show.");
    },
  ],
  onAbort: (why) => tell("The program broke off: " + why + ". Load the page again."),
};
if (window.knitPacked) window.knitPacked(Module);
if (!document.createElement("canvas").getContext("webgl2")) {
  tell("This browser draws no WebGL 2. Switch on hardware acceleration in its settings, or take a newer browser.");
  Module.noInitialRun = true;
}
