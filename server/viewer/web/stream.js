// SPDX-License-Identifier: BSD-3-Clause
// The server's stream: connects, tells what comes, and connects again whenever it ends, since the
// next episode may be a new server on the same port. Format: server/viewer/scene_json.h.

const knownVersion = 2;
const firstPause = 300;  // ms between attempts, growing to the longest
const longestPause = 2000;
const silence = 2000;  // ms without a message until we say that the simulation stands still

/**
 * Calls on.scene(scene), on.moment(moment), on.beliefs(by player) and on.state(state), state being one of
 *  "waiting" (no server yet), "lost" (it was there), "open" (nothing told yet), "live", "still"
 *  (connected, but nothing new), "outdated" (the server is newer than this page).
 */
export function openStream(on) {
  const url = new URL("stream", location.href);
  url.protocol = location.protocol === "https:" ? "wss:" : "ws:";
  let pause = firstPause;
  let everLive = false;
  let quiet = 0;
  let state = "";
  let outdated = false;  // the last scene was of another version, and so are moments and beliefs

  const tell = (next) => {
    if (next === state) return;
    state = next;
    on.state(state);
  };

  const take = (text) => {
    const message = JSON.parse(text);
    if (message.kind === "scene") {
      outdated = message.version !== knownVersion;
      if (outdated) return tell("outdated");
      on.scene(message);
      on.moment(message.now);
    } else if (outdated) {
      return;
    } else if (message.kind === "moment") {
      on.moment(message);
    } else if (message.kind === "beliefs") {
      return on.beliefs(message.players);
    }
    everLive = true;
    tell("live");
    clearTimeout(quiet);
    quiet = setTimeout(() => tell("still"), silence);
  };

  const connect = () => {
    const socket = new WebSocket(url);
    socket.onopen = () => {
      pause = firstPause;
      tell("open");
    };
    socket.onmessage = (event) => take(event.data);
    socket.onclose = () => {
      clearTimeout(quiet);
      tell(everLive ? "lost" : "waiting");
      setTimeout(connect, pause);
      pause = Math.min(longestPause, pause * 1.5);
    };
  };

  tell("waiting");
  connect();
}
