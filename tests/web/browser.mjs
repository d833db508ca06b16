// Headless Chromium driven through its own protocol, over two pipes: nothing but Node is needed.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export class Browser {
  constructor() {
    this.profile = mkdtempSync(join(tmpdir(), "knit-page-"));
    const flags = ["--headless=new", "--no-sandbox", "--remote-debugging-pipe", "--hide-scrollbars", "--mute-audio", "--no-first-run",
      "--use-angle=swiftshader", "--enable-unsafe-swiftshader", `--user-data-dir=${this.profile}`, "about:blank"];
    this.child = spawn("chromium", flags, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.waiting = new Map();
    this.heard = [];
    this.count = 0;
    let rest = "";
    this.child.stdio[4].on("data", (data) => {
      const parts = (rest + data).split("\0");
      rest = parts.pop();
      parts.forEach((part) => this.hear(JSON.parse(part)));
    });
  }

  hear(message) {
    if (message.id === undefined) return this.heard.forEach((call) => call(message));
    const { done, failed } = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) failed(new Error(message.error.message));
    else done(message.result);
  }

  send(method, params = {}, sessionId = undefined) {
    const id = ++this.count;
    this.child.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + "\0");
    return new Promise((done, failed) => this.waiting.set(id, { done, failed }));
  }

  async close() {
    await this.send("Browser.close").catch(() => {});
    await new Promise((done) => this.child.once("exit", done));
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }

  async open(address, width, height, touch = false) {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const page = new Page(this, sessionId, targetId);
    await page.send("Runtime.enable");
    await page.send("Page.enable");
    await page.size(width, height, touch);
    await page.send("Page.navigate", { url: address });
    return page;
  }
}

export class Page {
  constructor(browser, session, target) {
    this.browser = browser;
    this.session = session;
    this.target = target;
    this.errors = [];
    browser.heard.push((message) => {
      if (message.sessionId !== session) return;
      if (message.method === "Runtime.exceptionThrown") this.errors.push(message.params.exceptionDetails.text);
      if (message.method === "Runtime.consoleAPICalled" && message.params.type === "error")
        this.errors.push(message.params.args.map((arg) => arg.value).join(" "));
    });
  }

  send(method, params) {
    return this.browser.send(method, params, this.session);
  }

  size(width, height, touch) {
    if (touch) this.send("Emulation.setTouchEmulationEnabled", { enabled: true, maxTouchPoints: 2 });
    return this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: touch });
  }

  async value(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async until(expression, what, seconds = 60) {
    const end = Date.now() + 1000 * seconds;
    while (Date.now() < end) {
      if (await this.value(expression).catch(() => false)) return;
      await new Promise((later) => setTimeout(later, 100));
    }
    throw new Error(`${what}: waited ${seconds} s for nothing; errors: ${this.errors.join("; ")}`);
  }

  // The first frames are drawn, and then so many more.
  async drawn(more = 5) {
    await this.until("window.Module?.knit?.marks.frames > 2 || Module.knit.told", "the first frame");
    const told = await this.value("Module.knit.told");
    if (told) throw new Error("it says: " + told);
    const from = await this.value("Module.knit.marks.frames");
    await this.until(`Module.knit.marks.frames > ${from + more}`, "more frames");
  }

  async picture() {
    const { data } = await this.send("Page.captureScreenshot", { format: "png" });
    return Buffer.from(data, "base64");
  }

  async click(x, y) {
    for (const type of ["mouseMoved", "mousePressed", "mouseReleased"])
      await this.send("Input.dispatchMouseEvent", { type, x, y, button: type === "mouseMoved" ? "none" : "left", clickCount: 1 });
  }

  // A control's middle, by its name; null: it is not there.
  async middle(control) {
    const box = await this.value(`Module.knit.place(${JSON.stringify(control)})`);
    return box && [box[0] + box[2] / 2, box[1] + box[3] / 2];
  }

  // Once it is there, a click on it, and what that changes is drawn.
  async press(control) {
    await this.until(`Module.knit.place(${JSON.stringify(control)})`, control, 20);
    await this.click(...(await this.middle(control)));
    await this.drawn(3);
  }

  async type(text) {
    for (const key of text) {
      const about = { key, code: /[0-9]/.test(key) ? "Digit" + key : "", text: key };
      await this.send("Input.dispatchKeyEvent", { type: "keyDown", ...about });
      await this.send("Input.dispatchKeyEvent", { type: "keyUp", ...about });
    }
    await this.drawn(3);
  }

  async touch(type, ...places) {
    await this.send("Input.dispatchTouchEvent", { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
    await this.drawn(2);
  }

  close() {
    return this.browser.send("Target.closeTarget", { targetId: this.target });
  }
}
