// SPDX-License-Identifier: BSD-3-Clause
// The words over the picture: score board, state of the connection, camera buttons.
// Names come from the wire, so they only ever go into textContent.

const element = (id) => document.getElementById(id);

function setText(id, text) {
  const node = element(id);
  if (node.textContent !== text) node.textContent = text;
}

function clock(seconds) {
  if (typeof seconds !== "number") return "–";
  const tenths = Math.max(0, Math.floor(seconds * 10 + 1e-6));
  const minutes = Math.floor(tenths / 600);
  return `${minutes}:${String(Math.floor((tenths % 600) / 10)).padStart(2, "0")}.${tenths % 10}`;
}

/** Play modes are told as "KickOff_Left"; people read "Kick Off Left". */
const spaced = (mode) => mode.replace(/_/g, " ").replace(/([a-z])([A-Z])/g, "$1 $2");

export function showScene(scene) {
  setText("team-left", scene.teams[0] || "left");
  setText("team-right", scene.teams[1] || "right");
}

export function showMoment(moment) {
  setText("score", `${moment.score[0]} : ${moment.score[1]}`);
  setText("time", clock(moment.game_time));
  setText("mode", spaced(moment.play_mode));
  setText("episode", String(moment.episode));
}

const states = {
  waiting: [
    "waiting for server", "Waiting for the server",
    "The page connects by itself as soon as it is there."
  ],
  lost: [
    "waiting for server", "The server has ended",
    "The picture is its last. The page connects by itself to the next one."
  ],
  open: ["connected", "Connected", "Waiting for the first scene."],
  live: ["live"],
  still: ["simulation stands still"],
  outdated: ["outdated page", "The server is newer than this page", "Reload it."],
};

export function showState(state) {
  const [pill, title, text] = states[state];
  setText("state", pill);
  element("state").classList.toggle("live", state === "live");
  showNotice(title, text);
}

export function showNotice(title, text) {
  element("notice").hidden = !title;
  setText("notice-title", title ?? "");
  setText("notice-text", text ?? "");
}

/**
 * Buttons and keys for the cameras; `choose(name)` gets "overview", "top", "ball" or "robot N",
 *  N counting from 1 in the order of the scene.
 */
export function wireCameras(choose) {
  document.querySelector(".cameras").addEventListener("click", (event) => {
    const view = event.target.dataset?.view;
    if (view) choose(view);
  });
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const view = {o: "overview", t: "top", b: "ball"}[event.key.toLowerCase()];
    if (view)
      choose(view);
    else if (/^[1-9]$/.test(event.key))
      choose(`robot ${event.key}`);
  });
}

export function showRobotButtons(robots) {
  element("robots").replaceChildren(...robots.map((robot, index) => {
    const button = document.createElement("button");
    button.className = robot.team;
    button.dataset.view = `robot ${index + 1}`;
    button.title = `Follow robot ${robot.number}` + (index < 9 ? ` (${index + 1})` : "");
    button.textContent = robot.number;
    return button;
  }));
}

/** Beliefs have come: shows the button that hides them; `toggle()` returns whether they are shown. */
export function offerBeliefs(shown, toggle) {
  const button = element("beliefs");
  if (!button.hidden) return;
  const change = () => button.setAttribute("aria-pressed", String(toggle()));
  button.hidden = false;
  button.setAttribute("aria-pressed", String(shown));
  button.addEventListener("click", change);
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key.toLowerCase() === "v") change();
  });
}

export function showCamera(name) {
  for (const button of document.querySelectorAll(".cameras button[data-view]")) {
    button.setAttribute("aria-pressed", String(button.dataset.view === name));
  }
}
