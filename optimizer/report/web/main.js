// SPDX-License-Identifier: BSD-3-Clause
// The page of a run: messages from the daemon to words, plots and the champion's table.
import {Curves} from "./curves.js";

const at = (id) => document.getElementById(id);
const curves = new Curves(at("plots"));
const again = 1000;  // ms

/** What tests and the curious may look at. */
const run = (globalThis.run = {state: "connecting", course: null, status: null, curves});

function word(value) {
  return typeof value === "number" ? String(Number(value.toPrecision(4))) : String(value);
}

function showCourse(course) {
  run.course = course;
  document.title = course.name;
  at("name").textContent = course.name;
  at("what").textContent =
    `${course.algorithm} on ${course.task}, version ${course.version}. ${course.description}`;
  curves.show(course);
  const {champion} = course;
  at("score").textContent = champion
    ? `candidate ${champion.candidate}: ${word(champion.mean)} (se ${word(champion.se)}, ` +
      `n ${champion.n}, ${champion.validated ? "validation" : "training"} seeds)`
    : "none yet";
  at("champion").replaceChildren(...(champion?.values ?? []).map(([name, value]) => {
    const row = document.createElement("tr");
    for (const text of [name, word(value)])
      row.appendChild(document.createElement("td")).textContent = text;
    return row;
  }));
}

function showStatus(status) {
  run.status = status;
  const round = status.test ? "test of the champion" : `generation ${status.generation}`;
  at("state").textContent = `${round}: ${status.known} of ${status.episodes} episodes`;
  at("rates").textContent = `${status.backend}, ${status.rates}`;
  at("done").max = Math.max(1, status.episodes);
  at("done").value = status.known;
}

function connect() {
  const socket = new WebSocket(new URL("stream", location.href.replace(/^http/, "ws")));
  socket.onmessage = ({data}) => {
    run.state = "live";
    at("state").classList.remove("lost");
    const message = JSON.parse(data);
    if (message.course) showCourse(message.course);
    if (message.status) showStatus(message.status);
  };
  socket.onclose = () => {
    run.state = "lost";
    at("state").textContent = "the daemon has ended or cannot be reached; its report is in the run's folder";
    at("state").classList.add("lost");
    setTimeout(connect, again);
  };
}
connect();
