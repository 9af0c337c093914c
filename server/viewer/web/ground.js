// SPDX-License-Identifier: BSD-3-Clause
// What lies still: ground, painted lines, goals, walls, landmarks; and the keepaway area, which may
// shrink. Everything stands in the field frame: metres, z up.
import * as THREE from "three";

import {teamColour} from "./robots.js";

const lineWidth = 0.05;
const grass = 0x3f8a4b;
const outerGrass = 0x357a42;

function plane(width, height, z, material) {
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(width, height), material);
  mesh.position.z = z;
  mesh.receiveShadow = true;
  return mesh;
}

/** A painted stroke on the ground with round ends, so that corners close. */
function stroke([x0, y0, x1, y1], width, z, material) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  const group = new THREE.Group();
  const middle = plane(length, width, 0, material);
  group.add(middle);
  for (const end of [-1, 1]) {
    const disc = new THREE.Mesh(new THREE.CircleGeometry(width / 2, 12), material);
    disc.position.x = (end * length) / 2;
    disc.receiveShadow = true;
    group.add(disc);
  }
  group.position.set((x0 + x1) / 2, (y0 + y1) / 2, z);
  group.rotation.z = Math.atan2(y1 - y0, x1 - x0);
  return group;
}

function solid({name, centre, size}) {
  const goal = name.startsWith("goal");
  const side = name.startsWith("goal-left") ? "left" : "right";
  const material = new THREE.MeshLambertMaterial({
    color: goal ? teamColour(side) : 0x8fa3ad,
    transparent: true,
    opacity: goal ? 0.45 : 0.6,
    depthWrite: false,
  });
  const mesh = new THREE.Mesh(new THREE.BoxGeometry(...size), material);
  mesh.position.set(...centre);
  if (goal) {
    const edges = new THREE.EdgesGeometry(mesh.geometry);
    mesh.add(new THREE.LineSegments(edges, new THREE.LineBasicMaterial({color: 0xf4f7f9})));
  }
  return mesh;
}

function landmark({name, position}) {
  const group = new THREE.Group();
  const white = new THREE.MeshLambertMaterial({color: 0xf4f7f9});
  const yellow = new THREE.MeshLambertMaterial({color: 0xf2c53d});
  const flag = name.startsWith("F");
  const height = flag ? 0.5 : position[2];
  const pole = new THREE.Mesh(new THREE.CylinderGeometry(0.02, 0.02, height, 10), white);
  pole.rotation.x = Math.PI / 2;
  pole.position.z = height / 2;
  const knob = new THREE.Mesh(new THREE.SphereGeometry(0.05, 16, 10), yellow);
  knob.position.z = height;
  group.add(pole, knob);
  group.position.set(position[0], position[1], 0);
  return group;
}

/** The keepaway area: made once, stretched to the size that each moment tells. */
export class Area {
  constructor() {
    const edge = new THREE.MeshBasicMaterial({color: 0xffcf4a});
    const width = 0.06;
    const fill = new THREE.MeshBasicMaterial({color: 0xffffff, transparent: true, opacity: 0.07});
    this.group = new THREE.Group();
    this.fill = plane(1, 1, 0.003, fill);
    this.across = [-1, 1].map(() => plane(1, width, 0.009, edge));
    this.along = [-1, 1].map(() => plane(width, 1, 0.009, edge));
    this.corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => {
      const disc = new THREE.Mesh(new THREE.CircleGeometry(width / 2, 12), edge);
      disc.position.z = 0.009;
      disc.userData = {x, y};
      return disc;
    });
    this.group.add(this.fill, ...this.across, ...this.along, ...this.corners);
    this.group.visible = false;
  }

  /** `extent`: its full size, or null where there is no area. */
  show(extent) {
    this.group.visible = Boolean(extent);
    if (!extent) return;
    const [width, height] = extent;
    this.fill.scale.set(width, height, 1);
    this.across.forEach((line, i) => {
      line.scale.x = width;
      line.position.y = (i - 0.5) * height;
    });
    this.along.forEach((line, i) => {
      line.scale.y = height;
      line.position.x = (i - 0.5) * width;
    });
    for (const {position, userData} of this.corners) {
      position.x = (userData.x * width) / 2;
      position.y = (userData.y * height) / 2;
    }
  }

  /** As it is drawn; undefined where there is none. */
  get extent() {
    return this.group.visible ? this.fill.scale.toArray().slice(0, 2) : undefined;
  }
}

/** The still part of a scene. */
export function buildGround(scene) {
  const {field} = scene;
  const group = new THREE.Group();
  const paint = new THREE.MeshLambertMaterial({color: 0xf2f5f2});
  group.add(plane(140, 140, -0.01, new THREE.MeshLambertMaterial({color: outerGrass})));
  group.add(
    plane(field.length + 2, field.width + 2, 0, new THREE.MeshLambertMaterial({color: grass})));
  for (const line of field.lines) group.add(stroke(line, lineWidth, 0.006, paint));
  for (const box of field.solids) group.add(solid(box));
  for (const mark of field.landmarks) group.add(landmark(mark));
  return group;
}
