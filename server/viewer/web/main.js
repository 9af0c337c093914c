// SPDX-License-Identifier: BSD-3-Clause
// The page: stream -> scene -> picture. Tests look at it through window.k3d.
import * as THREE from "three";
import * as board from "./board.js";
import { View } from "./camera.js";
import { buildGround } from "./ground.js";
import { Players } from "./robots.js";
import { openStream } from "./stream.js";

const sky = 0xb9d0df;

/** Without a graphics card shadows halve the frame rate; ?shadows=on and ?shadows=off decide. */
function wantsShadows(gl) {
  const asked = new URLSearchParams(location.search).get("shadows");
  if (asked) return asked !== "off";
  const name = gl.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER;
  return !/swiftshader|llvmpipe|softpipe|software/i.test(gl.getParameter(name));
}

function openPicture(canvas) {
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  renderer.shadowMap.enabled = wantsShadows(renderer.getContext());
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(sky);
  scene.fog = new THREE.Fog(sky, 45, 120);
  scene.add(new THREE.HemisphereLight(0xffffff, 0x6f8f78, 1.7));
  const sun = new THREE.DirectionalLight(0xfff6e5, 2.0);
  sun.castShadow = renderer.shadowMap.enabled;
  sun.shadow.mapSize.set(2048, 2048);
  Object.assign(sun.shadow.camera, { left: -9, right: 9, bottom: -9, top: 9, near: 1, far: 60 });
  sun.shadow.normalBias = 0.01;
  scene.add(sun, sun.target);
  return { renderer, scene, sun };
}

/** Frees what a group holds on the graphics card. */
function discard(group) {
  group?.removeFromParent();
  group?.traverse((object) => {
    object.geometry?.dispose();
    object.material?.map?.dispose();
    object.material?.dispose();
  });
}

function start() {
  const canvas = document.getElementById("picture");
  const { renderer, scene, sun } = openPicture(canvas);
  const view = new View(canvas);
  let ground = null;
  let players = null;
  let latest = null;  // moment not drawn yet
  let shown = null;   // moment last drawn
  let state = "";
  let frames = 0;

  const followed = (name) => {
    const robot = /^robot (\d+)$/.exec(name);
    return robot ? players?.robots[robot[1] - 1] : name === "ball" ? players?.ball : undefined;
  };
  const positionOf = (name) => {
    const object = followed(name);
    return () => object.position;
  };
  const choose = (name) => {
    const still = name === "overview" || name === "top";
    if (!still && !followed(name)) return;
    view.choose(name, still ? null : positionOf(name));
    board.showCamera(name);
  };

  const resize = () => {
    renderer.setSize(innerWidth, innerHeight, false);
    view.resize(innerWidth / innerHeight);
  };

  board.wireCameras(choose);
  addEventListener("resize", resize);
  resize();
  choose("overview");

  openStream({
    scene(message) {
      discard(ground);
      discard(players?.group);
      ground = buildGround(message);
      players = new Players(message);
      players.move(message.now);
      scene.add(ground, players.group);
      view.setExtent(message.area ?? [message.field.length, message.field.width]);
      board.showScene(message);
      board.showRobotButtons(message.robots);
      // The same robot of the next episode goes on being followed, from where the user looks.
      if (view.follow && followed(view.name)) view.follow = positionOf(view.name);
      else if (view.follow) choose("overview");
      board.showCamera(view.name);
    },
    moment(message) { latest = message; },
    state(next) {
      state = next;
      board.showState(next);
    },
  });

  let before = performance.now();
  renderer.setAnimationLoop((now) => {
    if (latest && players) {
      players.move(latest);
      board.showMoment(latest);
      shown = latest;
      latest = null;
    }
    view.update((now - before) / 1000);
    before = now;
    // The sun's shadow map is sharp only over a small patch: it goes where the camera looks.
    sun.target.position.copy(view.controls.target).setZ(0);
    sun.position.copy(sun.target.position).add(new THREE.Vector3(-8, -10, 24));
    renderer.render(scene, view.camera);
    ++frames;
  });

  window.k3d = {
    get frames() { return frames; },
    get state() { return state; },
    get camera() { return view.name; },
    get time() { return shown?.time; },
    get playMode() { return shown?.play_mode; },
    get episode() { return shown?.episode; },
    get robots() {
      return (players?.robots ?? []).map(({ team, number, parts }) => ({ team, number, parts: parts.length }));
    },
    get ballPosition() { return players?.ball.position.toArray(); },
    get robotPositions() { return (players?.robots ?? []).map((robot) => robot.position.toArray()); },
    /** Where a point of the field frame is in the window, in pixels. */
    pixelOf(position) {
      const p = new THREE.Vector3(...position).project(view.camera);
      return [((p.x + 1) / 2) * innerWidth, ((1 - p.y) / 2) * innerHeight];
    },
    choose,
  };
}

try {
  start();
} catch (error) {
  board.showNotice("This browser cannot draw the scene", String(error?.message ?? error));
  throw error;
}
