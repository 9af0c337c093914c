// SPDX-License-Identifier: BSD-3-Clause
// Runs an experiment, small, and looks at its page while it runs and at its report when it has
// ended, in a real browser.
// usage: node run_test.mjs --optimizer PROGRAM --experiment FILE --out FOLDER
// Screenshots go to FOLDER. Exit code 0: all seen.
import {spawn} from "node:child_process";
import {existsSync, mkdirSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {join, resolve} from "node:path";
import {createInterface} from "node:readline";
import {pathToFileURL} from "node:url";
import {parseArgs} from "node:util";

import {startChromium} from "./chromium.mjs";
import {decodePng} from "./png.mjs";

const string = {
  type: "string"
};
const {values: option} =
  parseArgs({options: {optimizer: string, experiment: string, out: string, chromium: string}});
const out = resolve(option.out ?? "screenshots");
const chromium = option.chromium ?? "/usr/bin/chromium";
const patience = 240;  // s

// 2 generations of 6 candidates with 4 episodes each, and short ones.
const settings = [
  "algorithm.max_generations=2", "algorithm.cmaes.population=6", "algorithm.sampling.episodes=4",
  "algorithm.sampling.validation_episodes=2", "algorithm.sampling.finalists=1", "test.episodes=4",
  "task.settings=server:keepaway.limit=4"
];
const episodes = 2 * 6 * 4;

function check(what, holds) {
  console.log(`${holds ? "ok    " : "FAILED"} ${what}`);
  if (!holds) process.exitCode = 1;
}

/** How many different colours a picture has: a blank one has one. */
function colours(picture) {
  const seen = new Set();
  for (let x = 0; x < picture.width; x += 2)
    for (let y = 0; y < picture.height; y += 2) seen.add(picture.at(x, y).join());
  return seen.size;
}

async function save(page, name) {
  const png = await page.screenshot();
  writeFileSync(join(out, name), png);
  return decodePng(png);
}

function startRun(folder) {
  const flags = ["run", option.experiment, "--run", folder, "--jobs", "2", "--http", "0"];
  for (const setting of settings) flags.push("--set", setting);
  const child = spawn(option.optimizer, flags, {stdio: ["ignore", "pipe", "inherit"]});
  const lines = [];
  const ended = new Promise((done) => child.on("exit", done).on("error", done));
  const port = new Promise((found, reject) => {
    createInterface(child.stdout).on("line", (line) => {
      lines.push(line);
      const page = /^page: http:\/\/127\.0\.0\.1:(\d+)\/$/.exec(line);
      if (page) found(Number(page[1]));
    });
    ended.then((why) => reject(new Error(`the run ended: ${why}\n${lines.join("\n")}`)));
  });
  return {port, ended, lines, end: () => (child.kill("SIGINT"), ended)};
}

async function lookAtPage(page, port) {
  try {
    await page.open(`http://127.0.0.1:${await port}/`);
    await page.until("the run's page is live", "globalThis.run?.course && run.status", patience);
    await page.until("a closed generation on the page", "run.course.champion !== null", patience);
    await page.until("plots", "document.querySelectorAll('.uplot canvas').length >= 4", patience);
    const picture = await save(page, "page.png");
    const plots = await page.value("run.curves.count");
    check(`the page shows ${plots} plots, one for each parameter too`, plots >= 12);
    check(`they are drawn: ${colours(picture)} colours`, colours(picture) > 20);
    const rows = await page.value("document.querySelectorAll('#champion tr').length");
    check(`the champion's table has ${rows} rows`, rows === 10);
    const state = await page.value("document.getElementById('state').textContent");
    check(`the state is told: ${state}`, /^(generation|test of the champion|the daemon)/.test(state));
    const errors = page.errors.filter((error) => !/WebSocket connection to .* failed/.test(error));
    check(`no console errors${errors.map((e) => "\n    " + e).join("")}`, errors.length === 0);
  } finally {
    await page.close();
  }
}

async function lookAtReport(folder) {
  const report = join(folder, "report", "report.html");
  check("there is a report", existsSync(report));
  check("it needs nothing beside it", !/<(script|link|img)|src=|url\(/.test(readFileSync(report)));
  const page = await startChromium(chromium, {width: 1200, height: 2400});
  try {
    await page.open(pathToFileURL(report).href);
    const titles =
      await page.value("[...document.querySelectorAll('svg .title')].map((t) => t.textContent)");
    check(
      `${titles.length} plots: ${titles.slice(0, 3).join(" | ")}`,
      titles.length >= 13 && titles[0] === "Fitness");
    const drawn = await page.value(
      "[...document.querySelectorAll('svg')].every((svg) => svg.getBoundingClientRect().width > 300 " +
      "&& svg.querySelectorAll('path, rect, polygon').length > 0 && !/nan|inf/.test(svg.outerHTML))");
    check("every plot has lines and no number that is none", drawn);
    const cells = await page.value(
      "[...document.querySelectorAll('#champion tr')].slice(1).map((r) => r.cells[1].textContent)");
    check(`n of the champion's rows: ${cells}`, cells.slice(2).every((n) => n === "4"));
    const picture = await save(page, "report.png");
    check(`it is drawn: ${colours(picture)} colours`, colours(picture) > 30);
    check("no console errors", page.errors.length === 0);
  } finally {
    await page.close();
  }
  const lines = readFileSync(join(folder, "report", "episodes.csv"), "utf8").trim().split("\n");
  const trained = lines.filter((line) => line.startsWith("train,")).length;
  check(`${trained} training episodes in episodes.csv`, trained === episodes);
}

async function main() {
  mkdirSync(out, {recursive: true});
  const folder = join(out, `run-${process.pid}`);
  rmSync(folder, {recursive: true, force: true});
  // The browser may take longer to start than the run takes in all.
  const page = await startChromium(chromium);
  const run = startRun(folder);
  try {
    await lookAtPage(page, run.port);
    const code = await run.ended;
    check(`the run ends: ${run.lines.at(-1)}`, code === 0);
    await lookAtReport(folder);
  } finally {
    await run.end();
    if (!process.exitCode) rmSync(folder, {recursive: true, force: true});
  }
}

await main().catch((error) => {
  console.error(`FAILED ${error.message}`);
  process.exitCode = 1;
});
console.log(process.exitCode ? "run_test: failed" : `run_test: all seen; screenshots in ${out}`);
