// The page in headless Chromium: node tests/web/page_test.mjs PAGE SINGLE NATIVE, a folder, a file, a program. A line a check;
// exit code 1 where one does not hold. The pictures lie beside PAGE afterwards.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { serve } from "../../tools/serve_page.mjs";
import { Browser } from "./browser.mjs";
import { readPng, shareOff } from "./png.mjs";

const [folder, single, native] = process.argv.slice(2).map((path) => resolve(path));
const work = mkdtempSync(join(tmpdir(), "knit-page-test-"));
const { server, address } = await serve(folder, 0);
const browser = new Browser();
let failed = 0;

async function check(what, run) {
  const from = Date.now();
  try {
    const told = await run();
    console.log(`ok    ${what}${told ? ": " + told : ""} (${((Date.now() - from) / 1000).toFixed(1)} s)`);
  } catch (error) {
    ++failed;
    console.log(`FAIL  ${what}: ${error.message}`);
  }
}
function must(holds, words) {
  if (!holds) throw new Error(words);
}
// A file, once it lies there whole.
async function downloaded(path) {
  for (let i = 0; i < 200; ++i) {
    if (existsSync(path)) return readFileSync(path);
    await new Promise((later) => setTimeout(later, 100));
  }
  throw new Error(path + " never came");
}
const link = (words) => address + "#" + encodeURI(words);

async function clean(page) {
  must(page.errors.length === 0, "console: " + page.errors.join("; "));
  await page.close();
}

// The panel at the right tells what is measured beside the window, which a picture without one does not wait for.
const panel_px = 350;

await check("the thesis sphere's picture is the native one's", async () => {
  const words = ["--example", "thesis-sphere", "--at", "end"];
  execFileSync(native, [...words, "--headless", "--size", "1440x900", "--screenshot", join(work, "native.png")]);
  const wanted = readPng(readFileSync(join(work, "native.png")));
  const page = await browser.open(link(words.join(" ")), 1440, 900);
  await page.drawn(30);
  const picture = await page.picture();
  const off = shareOff(readPng(picture), wanted, 8, panel_px);
  await clean(page);
  await browser.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: join(work, "drawn") });
  const saved = await browser.open(link(words.join(" ") + " --headless --size 1440x900 --screenshot page.png"), 800, 600);
  const bytes = await downloaded(join(work, "drawn", "page.png"));
  const saved_off = shareOff(readPng(bytes), wanted, 8);
  await clean(saved);
  writeFileSync(join(folder, "..", "seen.png"), picture);
  writeFileSync(join(folder, "..", "saved.png"), bytes);
  writeFileSync(join(folder, "..", "native.png"), readFileSync(join(work, "native.png")));
  const told = [off, saved_off].map((share) => (100 * share).toFixed(3) + " %").join(" and, saved, ");
  must(off <= 0.005 && saved_off <= 0.005, told);
  return told + " of the pixels are off by more than 8 of 255";
});

await check("exports come as downloads and are the native ones", async () => {
  const words = "--example sphere --headless --save-mesh knit.obj --save-map map.txt --save-pattern pattern.txt";
  execFileSync(native, words.split(" "), { cwd: work });
  await browser.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: join(work, "got") });
  const page = await browser.open(link(words), 800, 600);
  await downloaded(join(work, "got", "knit-mesh.zip"));
  execFileSync("python3", ["-m", "zipfile", "-e", join(work, "got", "knit-mesh.zip"), join(work, "got")]);
  for (const name of ["knit.obj", "map.txt", "pattern.txt"])
    must(readFileSync(join(work, "got", name)).equals(readFileSync(join(work, name))), name + " differs");
  await clean(page);
  return "three files in a zip";
});

await check("a mesh that is dropped is opened", async () => {
  const page = await browser.open(link("--example sphere"), 1200, 800);
  await page.drawn();
  const mesh = readFileSync(join(folder, "..", "..", "dev", "assets", "egg", "mesh.obj")).toString();
  await page.value(`takeFiles([new File([${JSON.stringify(mesh)}], "my egg.obj")])`);
  await page.until('document.title.includes("my egg")', "its name in the title");
  await clean(page);
});

await check("an unknown word ends in a sentence", async () => {
  const page = await browser.open(link("--exampel sphere"), 800, 600);
  await page.until('document.getElementById("words").textContent.includes("exampel")', "the sentence");
  await clean(page);
});

// Numbers and choices are tried until one is right; what is asked in the picture is skipped.
async function answer(page, question) {
  const tries = question?.answer === "choice" ? question.choices.map((choice) => choice.is ?? choice.key) : question?.answer === "number" ? [..."123456789"] : [];
  for (const one of tries) {
    if (question.answer === "choice") {
      await page.press("lesson/choice/" + one);
    } else {
      await page.press("lesson/field");
      await page.send("Input.dispatchKeyEvent", { type: "keyDown", key: "a", code: "KeyA", modifiers: 2 });
      await page.send("Input.dispatchKeyEvent", { type: "keyUp", key: "a", code: "KeyA", modifiers: 2 });
      await page.type(one);
      await page.press("lesson/answer");
    }
    if (await page.middle("lesson/next")) return page.press("lesson/next");
  }
  must(tries.length === 0, `no answer is right: ${question?.ask}`);
  await page.press("lesson/skip");
  if (await page.middle("lesson/next")) await page.press("lesson/next");
}

// Whether a file in the browser's storage holds these words.
const has_kept = `(function holds(folder, words) {
  return FS.readdir(folder).filter((name) => name !== "." && name !== "..").some((name) => {
    const path = folder + "/" + name;
    if (FS.isDir(FS.stat(path).mode)) return holds(path, words);
    return FS.readFile(path, { encoding: "utf8" }).includes(words);
  });
})`;

await check("a lesson by link is answered to its end, and its score is kept over a reload", async () => {
  const lesson = JSON.parse(readFileSync(join(folder, "..", "..", "dev", "assets", "lessons", "8-why-a-handle.json")));
  const page = await browser.open(link("--lesson why-a-handle"), 1280, 800);
  await page.drawn();
  for (const { question } of lesson.pages) await answer(page, question);
  await page.until('Module.knit.place("lesson/score")', "the score", 10);
  const scores = `${has_kept}("/home/web_user", "why-a-handle")`;
  await page.until(scores, "the score among the preferences", 20);
  await new Promise((later) => setTimeout(later, 1000));
  await page.send("Page.reload");
  await page.until("window.Module?.knit?.marks.frames > 2", "the first frame after the reload");
  must(await page.value(scores), "the score is lost");
  await clean(page);
});

await check("one finger turns, two zoom, one held still is the right button", async () => {
  const page = await browser.open(link("--example sphere --at end"), 900, 700, true);
  await page.drawn();
  const seen = [await page.picture()];
  const moved = async (what) => {
    await page.drawn(20);
    seen.push(await page.picture());
    must(shareOff(readPng(seen.at(-1)), readPng(seen.at(-2)), 8) > 0.005, what + " changed nothing");
  };
  await page.touch("touchStart", [400, 300]);
  await page.touch("touchMove", [430, 300]);
  await page.touch("touchMove", [520, 330]);
  await page.touch("touchEnd");
  await moved("one finger");
  await page.touch("touchStart", [380, 300]);
  await page.touch("touchStart", [380, 300], [440, 300]);
  for (const by of [10, 20, 40, 60]) await page.touch("touchMove", [380 - by, 300], [440 + by, 300]);
  await page.touch("touchEnd");
  await moved("two fingers");
  await clean(page);
});

await check("the wheel is the course page's until somebody clicks", async () => {
  writeFileSync(join(folder, "course.html"),
    `<!doctype html><body style="height:4000px"><iframe src="index.html#--embed%20--example%20sphere" width="800" height="500"></iframe>`);
  const page = await browser.open(address + "course.html", 1000, 700);
  await page.until("frames[0]?.Module?.knit?.marks.frames > 2", "the first frame in the frame");
  await page.send("Input.dispatchMouseEvent", { type: "mouseWheel", x: 300, y: 300, deltaX: 0, deltaY: 200 });
  await page.until("scrollY > 0", "the page's scrolling", 10);
  await clean(page);
});

await check("one file opens from the disk", async () => {
  const page = await browser.open(pathToFileURL(single).href + "#" + encodeURI("--example sphere --at end"), 1000, 700);
  await page.drawn();
  await clean(page);
  return `${(readFileSync(single).length / 1e6).toFixed(1)} MB`;
});

await browser.close();
server.close();
rmSync(work, { recursive: true, force: true });
console.log(`${failed === 0 ? "All holds." : failed + " do not hold."}`);
process.exit(failed === 0 ? 0 : 1);
