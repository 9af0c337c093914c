// SPDX-License-Identifier: BSD-3-Clause
// Looks at the page in a real browser: robots and ball are drawn, they move, nothing complains.
// usage: node page_test.mjs --demo PROGRAM --out FOLDER       starts viewer_demo, and ends it and
//                                                             starts it again under the open page
//        node page_test.mjs --match OPTIMIZER --out FOLDER    plays a real match and looks at it
//        node page_test.mjs --url URL --out FOLDER            looks at a match that runs elsewhere
//   --robots N    how many there must be (5)
//   --moving N    how many of them must move (all; in a real match some may stand)
//   --seconds S   how long the browser may take for each step (60)
// Screenshots go to FOLDER. Exit code 0: all seen.
import {spawn} from "node:child_process";
import {mkdirSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {createInterface} from "node:readline";
import {parseArgs} from "node:util";

import {startChromium} from "./chromium.mjs";
import {decodePng} from "./png.mjs";

const string = {
  type: "string"
};
const {values: option} = parseArgs({
  options: {
    demo: string,
    match: string,
    url: string,
    out: string,
    robots: string,
    moving: string,
    seconds: string,
    chromium: string
  },
});
const out = option.out ?? "screenshots";
const patience = Number(option.seconds ?? 60);

function check(what, holds) {
  console.log(`${holds ? "ok    " : "FAILED"} ${what}`);
  if (!holds) process.exitCode = 1;
}

async function save(page, name) {
  const png = await page.screenshot();
  writeFileSync(join(out, name), png);
  return decodePng(png);
}

/** Pixels of the middle of a picture that look like it. */
function count(picture, half, looksRight) {
  let found = 0;
  for (let x = picture.width / 2 - half; x < picture.width / 2 + half; ++x) {
    for (let y = picture.height / 2 - half; y < picture.height / 2 + half; ++y) {
      if (looksRight(...picture.at(x, y))) ++found;
    }
  }
  return found;
}
const isBlue = (r, g, b) => b > 90 && b > r + 50 && b > g + 20;
const isRed = (r, g, b) => r > 90 && r > g + 50 && r > b + 50;
const isWhite = (r, g, b) => Math.min(r, g, b) > 170;
const isRing = (r, g, b) =>
  r > 190 && g > 180 && b > 100 && r - b > 45;  // around the ball, on the ground

const distance = (a, b) => Math.hypot(...a.map((v, i) => v - b[i]));

/** As soon as there is such a one: while a match's next server waits for its players, no robots are. */
async function follow(page, name) {
  const wanted = JSON.stringify(name);
  await page.until(
    `${name} is followed`, `(k3d.choose(${wanted}), k3d.camera === ${wanted})`, patience);
  const frames = await page.value("k3d.frames");
  await page.until(`two more frames of ${name}`, `k3d.frames > ${frames + 2}`, patience);
}

/** `wanted` of so many robots move, and the ball, in the course of one episode. */
async function checkMoving(page, robots, wanted) {
  const read = () => page.value(
    "({ robots: k3d.robotPositions, ball: k3d.ballPosition, time: k3d.time, episode: k3d.episode })");
  const end = Date.now() + patience * 1000;
  let moved = 0;
  let rolled = 0;
  let before = await read();
  let now = before;
  while (Date.now() < end && (moved < wanted || rolled < 0.05)) {
    await new Promise((resolve) => setTimeout(resolve, 100));
    now = await read();
    // Between two episodes there are no robots, and the next one's stand elsewhere.
    if (before.robots.length !== robots || now.robots.length !== robots ||
        now.episode !== before.episode)
      before = now;
    moved =
      now.robots.filter((position, i) => distance(position, before.robots[i]) > 0.05).length;
    rolled = distance(now.ball, before.ball);
  }
  check(
    `${moved} robots moved (at least ${wanted}), the ball by ${rolled.toFixed(2)} m, within ` +
      `${(now.time - before.time).toFixed(1)} s of simulation`,
    moved >= wanted && rolled >= 0.05);
}

/**
 * Follows it and takes pictures until one looks right, or patience ends; what the last one shows. The
 * browser of a busy machine may hand out an older picture than its page has drawn, and at a match's
 * next episode the page stops following.
 */
async function look(page, name, file, countIn, looksRight) {
  const end = Date.now() + patience * 1000;
  for (;;) {
    await follow(page, name);
    const found = countIn(await save(page, file));
    if (looksRight(found) || Date.now() > end) return found;
    await new Promise((resolve) => setTimeout(resolve, 250));
  }
}

async function checkDrawn(page, robots) {
  for (const [index, robot] of robots.entries()) {
    const colour = robot.team === "left" ? isBlue : isRed;
    const enough = (pixels) => pixels > 1500;
    const pixels = await look(
      page, `robot ${index + 1}`, `robot-${robot.team}-${robot.number}.png`,
      (picture) => count(picture, 120, colour), enough);
    check(
      `robot ${robot.team} ${robot.number} is drawn: ${pixels} pixels of its colour`,
      enough(pixels));
  }
  const enough = ([white, ring]) => white > 200 && ring > 500;
  const seen = await look(
    page, "ball", "ball.png",
    (picture) => [isWhite, isRing].map((colour) => count(picture, 120, colour)), enough);
  check(
    `the ball is drawn: ${seen[0]} white pixels, ${seen[1]} of the ring around it`, enough(seen));
}

/**
 * Opens the page. Between two episodes of a match there is no server, or one ends while it sends the
 * page: then it is opened again.
 */
async function openPage(page, url) {
  const end = Date.now() + patience * 1000;
  for (;;) {
    try {
      await page.open(url);
      if (await page.value("window.k3d !== undefined")) return;
      throw new Error(`${url} has no k3d; errors: ${page.errors.join("; ") || "none"}`);
    } catch (error) {
      if (option.demo || Date.now() > end) throw error;
    }
    await new Promise((resolve) => setTimeout(resolve, 250));
  }
}

/** What must be seen whoever serves the page. */
async function checkScene(page) {
  const wanted = Number(option.robots ?? 5);
  const robots = await page.until(
    `${wanted} robots`, `k3d.state === "live" && k3d.robots.length === ${wanted} && k3d.robots`,
    patience);
  const teams = robots.map(({team, number}) => `${team} ${number}`).join(", ");
  check(`${robots.length} robots: ${teams}`, robots.every(({parts}) => parts >= 22));
  await follow(page, "overview");
  await save(page, "overview.png");
  await checkMoving(page, wanted, Number(option.moving ?? wanted));
  await checkDrawn(page, robots);
  await page.key("t");
  check("keys choose the camera", (await page.value("k3d.camera")) === "top");
  await follow(page, "top");
  await save(page, "top.png");
  const shown =
    await page.value("[...document.querySelectorAll('.board b')].map((b) => b.textContent)");
  check(
    `the board shows time, mode, episode: ${shown.join(" | ")}`,
    shown.every((text) => text.length > 0));
  // Between two episodes of a match nobody listens; Chromium reports each attempt to connect.
  const errors = page.errors.filter((error) => !/WebSocket connection to .* failed/.test(error));
  check(`no console errors${errors.map((e) => "\n    " + e).join("")}`, errors.length === 0);
}

function startDemo(port, episode) {
  const child = spawn(
    option.demo, [String(port), ...(episode ? [webFolder(), String(episode)] : [])],
    {stdio: ["ignore", "pipe", "inherit"]});
  const ended = new Promise((resolve) => child.on("exit", resolve).on("error", resolve));
  const ready = new Promise((resolve, reject) => {
    createInterface(child.stdout).on("line", (line) => {
      const found = /^ready http=(\d+)$/.exec(line);
      if (found) resolve(Number(found[1]));
    });
    ended.then((why) => reject(new Error(`${option.demo} ended: ${why}`)));
  });
  return {ready, end: () => (child.kill("SIGKILL"), ended)};
}
/** A real match: server and five agents, played as fast as they can be watched. */
function startMatch() {
  const flags = ["match", "--pace", "sync", "--http", "0", "--episodes", "100", "--seed", "1"];
  const child = spawn(option.match, flags, {stdio: ["ignore", "pipe", "inherit"]});
  const ended = new Promise((resolve) => child.on("exit", resolve).on("error", resolve));
  const ready = new Promise((resolve, reject) => {
    createInterface(child.stdout).on("line", (line) => {
      const found = /^page: http:\/\/127\.0\.0\.1:(\d+)\/$/.exec(line);
      if (found) resolve(Number(found[1]));
    });
    ended.then((why) => reject(new Error(`${option.match} ended: ${why}`)));
  });
  return {ready, end: () => (child.kill("SIGINT"), ended)};
}
const webFolder = () => join(option.demo, "..", "..", "web");

/** The area's lines follow its size, and nothing is built anew for that. */
async function checkShrinking(page) {
  await page.until("an area", "window.k3d?.state === 'live' && k3d.area", patience);
  const scenes = await page.value("k3d.scenes");
  const [before] = await page.value("k3d.area");
  await page.until(
    "another size of the area",
    `Math.abs(k3d.area[0] - ${before}) > 0.1 && k3d.area[1] === k3d.area[0]`, patience);
  check("the area that is drawn shrinks", before <= 10 && before >= 8);
  check("the scene is not told anew for that", (await page.value("k3d.scenes")) === scenes);
}

/** The next episode is a new server on the same port: an open page says so and goes on. */
async function checkRestart(page, demo, port) {
  await page.value("k3d.choose('robot 5')");
  await demo.end();
  await page.until(
    "the page says that the server has ended",
    "k3d.state === 'lost' && !document.getElementById('notice').hidden", patience);
  await save(page, "lost.png");
  const next = startDemo(port, 2);
  await next.ready;
  try {
    await page.until(
      "the page finds the next server", "k3d.state === 'live' && k3d.episode === 2", patience);
    check("the page finds the next server by itself", true);
    check("it goes on following the same robot", (await page.value("k3d.camera")) === "robot 5");
    await page.value("k3d.choose('overview')");
    await checkMoving(page, 5, 5);
  } finally {
    await next.end();
  }
}

/** What keepers believe is drawn, and the button hides it. */
async function checkBeliefs(page) {
  await page.until("three keepers' beliefs", "k3d.believers.length === 3", patience);
  const button = "document.getElementById('beliefs')";
  check("beliefs can be hidden", await page.value(`!${button}.hidden`));
  const pressed = () => page.value(`${button}.getAttribute("aria-pressed")`);
  const before = await pressed();
  await save(page, "beliefs.png");
  await page.key("v");
  check("a key hides them", before === "true" && (await pressed()) === "false");
}

async function main() {
  if ([option.demo, option.match, option.url].filter(Boolean).length !== 1)
    throw new Error("give one of --demo, --match and --url");
  mkdirSync(out, {recursive: true});
  // The browser may take its time to start; a match goes on meanwhile.
  const page = await startChromium(option.chromium ?? "/usr/bin/chromium");
  let shown = null;
  try {
    const demo = option.demo ? startDemo(0, 0) : null;
    shown = demo ?? (option.match ? startMatch() : null);
    const port = await shown?.ready;
    await openPage(page, option.url ?? `http://127.0.0.1:${port}/`);
    if (demo) await checkShrinking(page);
    await checkScene(page);
    if (demo) await checkRestart(page, demo, port);
    if (option.match) await checkBeliefs(page);
  } finally {
    await page.close();
    await shown?.end();
  }
}

await main().catch((error) => {
  console.error(`FAILED ${error.message}`);
  process.exitCode = 1;
});
console.log(process.exitCode ? "page_test: failed" : `page_test: all seen; screenshots in ${out}`);
