// SPDX-License-Identifier: BSD-3-Clause
// What server/viewer/web/stream.js makes of a stream, without browser and server.
// usage: node stream_test.mjs WEB-FOLDER       exit code 0: all as it should be
import {readFileSync} from "node:fs";
import {join} from "node:path";

/** Imported as text: for node the page's file need not be a module. */
async function importStream(folder) {
  const text = readFileSync(join(folder, "stream.js"), "utf8");
  return import(`data:text/javascript;base64,${Buffer.from(text).toString("base64")}`);
}

/** The page's connection, by which the test plays the server. */
class Socket {
  static last = null;
  constructor() { Socket.last = this; }
  tell(message) { this.onmessage({data: JSON.stringify(message)}); }
}

function check(what, got, wanted) {
  const holds = JSON.stringify(got) === JSON.stringify(wanted);
  console.log(`${holds ? "ok    " : "FAILED"} ${what}${holds ? "" : `: ${JSON.stringify(got)}`}`);
  if (!holds) process.exitCode = 1;
}

const {openStream} = await importStream(process.argv[2]);
globalThis.location = {href: "http://127.0.0.1:8080/", protocol: "http:"};
globalThis.WebSocket = Socket;
const heard = [];
openStream({
  scene: () => heard.push("scene"),
  moment: () => heard.push("moment"),
  beliefs: () => heard.push("beliefs"),
  state: (state) => heard.push(state),
});
/** What the page hears when the server says this. */
const after = (...messages) => {
  heard.length = 0;
  messages.forEach((message) => Socket.last.tell(message));
  return [...heard];
};
const scene = (version) => ({kind: "scene", version, now: {}});
const moment = {kind: "moment"};
const beliefs = {kind: "beliefs", players: {}};
const known = 2;

Socket.last.onopen();
check("it waits, then it is open", heard, ["waiting", "open"]);
check(
  "of a newer server's stream only that it is newer is told",
  after(scene(known + 1), moment, beliefs, scene(known + 1), moment), ["outdated"]);
check(
  "a scene that is understood ends that", after(scene(known), moment, beliefs),
  ["scene", "moment", "live", "moment", "beliefs"]);
process.exit();
