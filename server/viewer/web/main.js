// SPDX-License-Identifier: BSD-3-Clause
// The page: stream -> scene -> picture. Tests look at it through window.k3d.
import * as THREE from "three";

import {Beliefs} from "./beliefs.js";
import * as board from "./board.js";
import {View} from "./camera.js";
import {Area, buildGround} from "./ground.js";
import {Players} from "./robots.js";
import {openStream} from "./stream.js";

const sky = 0xb9d0df;

/** Without a graphics card shadows halve the frame rate; ?shadows=on and ?shadows=off decide. */
function wantsShadows(gl) {
  const asked = new URLSearchParams(location.search).get("shadows");
  if (asked) return asked !== "off";
  const name = gl.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER;
  return !/swiftshader|llvmpipe|softpipe|software/i.test(gl.getParameter(name));
}

function openPicture(canvas) {
  const renderer = new THREE.WebGLRenderer({canvas, antialias: true});
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  renderer.shadowMap.enabled = wantsShadows(renderer.getContext());
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(sky);
  scene.fog = new THREE.Fog(sky, 45, 120);
  scene.add(new THREE.HemisphereLight(0xffffff, 0x6f8f78, 1.7));
  const sun = new THREE.DirectionalLight(0xfff6e5, 2.0);
  sun.castShadow = renderer.shadowMap.enabled;
  sun.shadow.mapSize.set(2048, 2048);
  Object.assign(sun.shadow.camera, {left: -9, right: 9, bottom: -9, top: 9, near: 1, far: 60});
  sun.shadow.normalBias = 0.01;
  scene.add(sun, sun.target);
  return {renderer, scene, sun};
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

/** What tests see of the page. */
function hookOf(show, view, choose, beliefs, area) {
  const robots = () => show.players?.robots ?? [];
  return {
    get frames() { return show.frames; },
    get state() { return show.state; },
    get camera() { return view.name; },
    get time() { return show.shown?.time; },
    get playMode() { return show.shown?.play_mode; },
    get episode() { return show.shown?.episode; },
    get robots() {
      return robots().map(({team, number, parts}) => ({team, number, parts: parts.length}));
    },
    get ballPosition() { return show.players?.ball.position.toArray(); },
    get scenes() { return show.scenes; },
    get area() { return area.extent; },
    get believers() { return beliefs.players; },
    get robotPositions() { return robots().map((robot) => robot.position.toArray()); },
    choose,
  };
}

/**
 * Cameras by name: "overview", "top", "ball", "robot N" with N from 1 in the order of the scene.
 */
function cameras(show, view) {
  const followed = (name) => {
    const robot = /^robot (\d+)$/.exec(name);
    if (robot) return show.players?.robots[robot[1] - 1];
    return name === "ball" ? show.players?.ball : undefined;
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
  /** The same robot of the next scene goes on being followed, from where the user looks. */
  const keep = () => {
    if (view.follow && followed(view.name))
      view.follow = positionOf(view.name);
    else if (view.follow)
      choose("overview");
    board.showCamera(view.name);
  };
  return {choose, keep};
}

function start() {
  const canvas = document.getElementById("picture");
  const {renderer, scene, sun} = openPicture(canvas);
  const view = new View(canvas);
  // latest: moment not drawn yet; shown: moment last drawn
  const show = {
    ground: null,
    players: null,
    latest: null,
    shown: null,
    state: "",
    frames: 0,
    scenes: 0,
  };
  const {choose, keep} = cameras(show, view);
  const beliefs = new Beliefs(scene);
  const area = new Area();
  scene.add(area.group);

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
      discard(show.ground);
      discard(show.players?.group);
      show.ground = buildGround(message);
      show.players = new Players(message);
      show.players.move(message.now);
      scene.add(show.ground, show.players.group);
      view.setExtent(message.now.area ?? [message.field.length, message.field.width]);
      ++show.scenes;
      board.showScene(message);
      board.showRobotButtons(message.robots);
      keep();
    },
    moment(message) { show.latest = message; },
    beliefs(players) {
      beliefs.take(players);
      board.offerBeliefs(beliefs.shown, () => {
        beliefs.toggle();
        return beliefs.shown;
      });
    },
    state(next) {
      show.state = next;
      board.showState(next);
    },
  });

  let before = performance.now();
  renderer.setAnimationLoop((now) => {
    if (show.latest && show.players) {
      show.players.move(show.latest);
      area.show(show.latest.area);
      // An area that has shrunk is as large again in the next episode.
      if (show.latest.area?.[0] > view.extent[0]) view.setExtent(show.latest.area);
      board.showMoment(show.latest);
      beliefs.expire(show.latest.time);
      show.shown = show.latest;
      show.latest = null;
    }
    view.update((now - before) / 1000);
    before = now;
    // The sun's shadow map is sharp only over a small patch: it goes where the camera looks.
    sun.target.position.copy(view.controls.target).setZ(0);
    sun.position.copy(sun.target.position).add(new THREE.Vector3(-8, -10, 24));
    renderer.render(scene, view.camera);
    ++show.frames;
  });
  window.k3d = hookOf(show, view, choose, beliefs, area);
}

try {
  start();
} catch (error) {
  board.showNotice("This browser cannot draw the scene", String(error?.message ?? error));
  throw error;
}
