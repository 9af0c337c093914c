// SPDX-License-Identifier: BSD-3-Clause
// A headless Chromium of our own, spoken to in its DevTools protocol over a pipe: messages are
// JSON texts, each ended by a NUL. Needs nothing but Node.
import {spawn} from "node:child_process";
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";

const flags = [
  "--headless=new", "--remote-debugging-pipe", "--no-sandbox", "--no-first-run", "--disable-quic",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
  "--disable-dev-shm-usage", "--hide-scrollbars", "--mute-audio", "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",  // WebGL without a graphics card
];

/** Starts `program`; resolves to a Page that shows nothing yet. */
export async function startChromium(program, {width = 1280, height = 800} = {}) {
  const profile = mkdtempSync(join(tmpdir(), "k3d-chromium-"));
  const child = spawn(
    program, [...flags, `--window-size=${width},${height}`, `--user-data-dir=${profile}`],
    {stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"]});
  const page = new Page(child, profile);
  try {
    await page.attach(width, height);
  } catch (error) {
    await page.close();
    throw error;
  }
  return page;
}

class Page {
  constructor(child, profile) {
    this.child = child;
    this.profile = profile;
    this.errors = [];  // of the page's console, of its scripts, of loading it
    this.waiting = new Map();
    this.loaded = new Map();  // loader -> what to call once its document is whole
    this.last = 0;
    this.session = undefined;
    let rest = "";
    child.stdio[4].setEncoding("utf8").on("data", (text) => {
      const messages = (rest + text).split("\0");
      rest = messages.pop();
      for (const message of messages) this.take(JSON.parse(message));
    });
    child.stdio[3].on("error", () => {});  // its end is told by "exit"
    this.ended = new Promise((resolve) => {
      child.on("error", (error) => this.fail(error, resolve));
      child.on(
        "exit",
        (code, signal) => this.fail(new Error(`Chromium ended (${code ?? signal})`), resolve));
    });
  }

  fail(error, resolve) {
    for (const {reject} of this.waiting.values()) reject(error);
    for (const {reject} of this.loaded.values()) reject(error);
    this.waiting.clear();
    this.dead = error;
    resolve();
  }

  send(method, params = {}) {
    if (this.dead) return Promise.reject(this.dead);
    const id = ++this.last;
    this.child.stdio[3].write(JSON.stringify({id, method, params, sessionId: this.session}) + "\0");
    return new Promise((resolve, reject) => this.waiting.set(id, {resolve, reject, method}));
  }

  take({id, method, params, result, error}) {
    if (id) {
      const asked = this.waiting.get(id);
      this.waiting.delete(id);
      if (error)
        asked?.reject(new Error(`${asked.method}: ${error.message}`));
      else
        asked?.resolve(result);
    } else if (method === "Runtime.exceptionThrown") {
      const {text, exception} = params.exceptionDetails;
      this.errors.push(exception?.description ?? text);
    } else if (method === "Runtime.consoleAPICalled" && [
                 "error", "warning", "assert"
               ].includes(params.type)) {
      this.errors.push(params.args.map((arg) => arg.value ?? arg.description).join(" "));
    } else if (method === "Log.entryAdded" && params.entry.level === "error") {
      this.errors.push(`${params.entry.text} ${params.entry.url ?? ""}`);
    } else if (method === "Page.lifecycleEvent" && params.name === "load") {
      this.whole(params.loaderId).resolve();
    }
  }

  /** A promise, with its ends, of a loader's document being whole; the event may come first. */
  whole(loader) {
    if (!this.loaded.has(loader)) {
      const ends = {};
      ends.promise = new Promise((resolve, reject) => Object.assign(ends, {resolve, reject}));
      ends.promise.catch(() => {});  // told by the sends that fail
      this.loaded.set(loader, ends);
    }
    return this.loaded.get(loader);
  }

  async attach(width, height) {
    const {targetId} = await this.send("Target.createTarget", {url: "about:blank"});
    this.session = (await this.send("Target.attachToTarget", {targetId, flatten: true})).sessionId;
    for (const domain of ["Runtime", "Log", "Page"]) await this.send(`${domain}.enable`);
    await this.send(
      "Emulation.setDeviceMetricsOverride", {width, height, deviceScaleFactor: 1, mobile: false});
    await this.send("Page.setLifecycleEventsEnabled", {enabled: true});
  }

  /** Shows `url`; from then on `errors` are those of its page. */
  async open(url) {
    this.errors = [];
    const {errorText, loaderId} = await this.send("Page.navigate", {url});
    if (errorText) throw new Error(`cannot open ${url}: ${errorText}`);
    await this.whole(loaderId).promise;
  }

  /** Value of a JavaScript expression in the page. */
  async value(expression) {
    const {result, exceptionDetails} =
      await this.send("Runtime.evaluate", {expression, returnByValue: true, awaitPromise: true});
    if (exceptionDetails)
      throw new Error(`${expression}: ${exceptionDetails.exception?.description}`);
    return result.value;
  }

  /** Waits until the expression is true, and gives its value; `what` names it if it never is. */
  async until(what, expression, seconds = 60) {
    const end = Date.now() + seconds * 1000;
    for (;;) {
      const value = await this.value(expression);
      if (value) return value;
      if (Date.now() > end)
        throw new Error(
          `not within ${seconds} s: ${what}; errors: ${this.errors.join("; ") || "none"}`);
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }

  /** The window as a PNG. */
  async screenshot() {
    return Buffer.from((await this.send("Page.captureScreenshot", {format: "png"})).data, "base64");
  }

  async key(key) {
    for (const type of ["keyDown", "keyUp"]) await this.send("Input.dispatchKeyEvent", {type, key});
  }

  async close() {
    this.session = undefined;
    if (!this.dead) this.send("Browser.close").catch(() => {});
    const timer = setTimeout(() => this.child.kill("SIGKILL"), 5000);
    await this.ended;
    clearTimeout(timer);
    // Its helpers outlive it for a moment, and write there.
    rmSync(this.profile, {recursive: true, force: true, maxRetries: 20});
  }
}
