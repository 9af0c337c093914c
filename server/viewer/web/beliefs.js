// SPDX-License-Identifier: BSD-3-Clause
// What agents believe, drawn over the truth: where an agent thinks it stands (arrow), where it thinks
// the ball is (small ball), how it will roll (line) and where it will rest (ring), the targets that
// K1 has scored (discs, green is best) and the one that it has chosen (cross).
// A belief is a line of an agent's telemetry, see agent/action/telemetry.h: field frame, m, degrees.
import * as THREE from "three";

const fresh = 1.0;  // s after which a belief is no longer shown
const ballRadius = 0.042;
const colours = [0x2f9bff, 0xff9f1c, 0xc77dff, 0x2ec4b6, 0xff5d8f, 0xf4f1de];

function flat(shape, material, x, y, z) {
  const mesh = new THREE.Mesh(shape, material);
  mesh.position.set(x, y, z);
  return mesh;
}

function path(points, z, material) {
  const geometry = new THREE.BufferGeometry().setFromPoints(
    points.map(([x, y]) => new THREE.Vector3(x, y, z)));
  return new THREE.Line(geometry, material);
}

/** An outline that points ahead, about as wide as a robot. */
function arrow({x, y, yaw_deg}, material) {
  const yaw = (yaw_deg * Math.PI) / 180;
  const at = (ahead, left) => [
    x + ahead * Math.cos(yaw) - left * Math.sin(yaw), y + ahead * Math.sin(yaw) + left * Math.cos(yaw)];
  return path([at(0.35, 0), at(-0.15, 0.2), at(-0.05, 0), at(-0.15, -0.2), at(0.35, 0)], 0.02, material);
}

/** Targets by their rank: the best are green and large, the worst red and small. */
function targets(scored, group) {
  const costs = scored.map(([, , cost]) => cost).sort((a, b) => a - b);
  for (const [x, y, cost] of scored) {
    const rank = costs.length > 1 ? costs.indexOf(cost) / (costs.length - 1) : 0;
    const colour = new THREE.Color().setHSL((1 - rank) / 3, 0.9, 0.5);
    const material = new THREE.MeshBasicMaterial({color: colour, transparent: true, opacity: 0.8});
    group.add(flat(new THREE.CircleGeometry(0.14 - 0.09 * rank, 20), material, x, y, 0.012));
  }
}

function draw(belief, colour) {
  const group = new THREE.Group();
  const line = new THREE.LineBasicMaterial({color: colour});
  const fill = new THREE.MeshBasicMaterial({color: colour, transparent: true, opacity: 0.9});
  const {pose, ball, target} = belief;
  if (pose?.localised) group.add(arrow(pose, line));
  if (ball) {
    group.add(flat(new THREE.SphereGeometry(ballRadius * 0.9, 12, 8), fill, ball.x, ball.y, 0.12));
    group.add(path([[ball.x, ball.y], [ball.finish_x, ball.finish_y]], 0.02, line));
    group.add(flat(new THREE.RingGeometry(0.09, 0.12, 24), fill, ball.finish_x, ball.finish_y, 0.018));
  }
  if (belief.scored?.length) targets(belief.scored, group);
  if (target) {
    const {x, y} = target;
    group.add(path([[x - 0.15, y - 0.15], [x + 0.15, y + 0.15]], 0.03, line));
    group.add(path([[x - 0.15, y + 0.15], [x + 0.15, y - 0.15]], 0.03, line));
  }
  return group;
}

function discard(group) {
  group.removeFromParent();
  group.traverse((object) => {
    object.geometry?.dispose();
    object.material?.dispose();
  });
}

export class Beliefs {
  constructor(scene) {
    this.group = new THREE.Group();
    this.drawn = new Map();  // player -> {time, group}
    scene.add(this.group);
  }

  get players() { return [...this.drawn.keys()]; }
  get shown() { return this.group.visible; }
  toggle() { this.group.visible = !this.group.visible; }

  /** `players`: the newest belief of each, by name. */
  take(players) {
    const names = Object.keys(players).sort();
    for (const [index, name] of names.entries()) {
      if (this.drawn.get(name)?.time === players[name].time) continue;
      this.forget(name);
      const group = draw(players[name], colours[index % colours.length]);
      this.group.add(group);
      this.drawn.set(name, {time: players[name].time, group});
    }
  }

  /** Beliefs that are old, or of an episode before, go. */
  expire(time) {
    for (const [name, {time: told}] of this.drawn)
      if (time - told > fresh || time < told - fresh) this.forget(name);
  }

  forget(name) {
    const old = this.drawn.get(name);
    if (!old) return;
    discard(old.group);
    this.drawn.delete(name);
  }
}
