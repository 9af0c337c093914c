// SPDX-License-Identifier: BSD-3-Clause
// What moves: robots as the boxes, spheres and capsules they are made of, and the ball.
import * as THREE from "three";

const colours = {
  left: 0x3d8bf2,
  right: 0xf0544a,
  none: 0x8d99a3
};
const labelHeight = 0.26;  // above the torso's centre
const coloured = /^(body|[rl]upperarm|[rl]thigh|[rl]foot|[rl]toe)$/;

export const teamColour = (team) => colours[team] ?? colours.none;

/** Sets position and rotation from seven whole numbers at `at`; leaves them if one is missing. */
function place(object, numbers, at) {
  for (let i = at; i < at + 7; ++i) {
    if (typeof numbers[i] !== "number") return;
  }
  object.position.set(numbers[at] / 1e4, numbers[at + 1] / 1e4, numbers[at + 2] / 1e4);
  object.quaternion.set(numbers[at + 4], numbers[at + 5], numbers[at + 6], numbers[at + 3])
    .normalize();
}

function shapeOf({shape, size}) {
  if (shape === "box") return new THREE.BoxGeometry(...size);
  if (shape === "sphere") return new THREE.SphereGeometry(size[0], 24, 16);
  const capsule = new THREE.CapsuleGeometry(size[0], size[1], 6, 16);
  return capsule.rotateX(Math.PI / 2);  // ours lie along z, three's along y
}

function materialOf(part, team) {
  if (!part.collides) return new THREE.MeshLambertMaterial({color: 0x4b545c});
  const color = coloured.test(part.name) ? teamColour(team) : 0xeef1f3;
  return new THREE.MeshLambertMaterial({color});
}

/** A dark visor shows which way a head looks (+y is forward). */
function visor(radius) {
  const geometry = new THREE.SphereGeometry(radius, 20, 14).scale(0.86, 0.62, 0.42);
  const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({color: 0x20262b}));
  mesh.position.set(0, radius * 0.5, radius * 0.14);
  return mesh;
}

function label(number, team) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const paint = canvas.getContext("2d");
  paint.fillStyle = "#" + teamColour(team).toString(16).padStart(6, "0");
  paint.strokeStyle = "#ffffff";
  paint.lineWidth = 5;
  paint.beginPath();
  paint.arc(32, 32, 28, 0, 2 * Math.PI);
  paint.fill();
  paint.stroke();
  paint.fillStyle = "#ffffff";
  paint.font = "bold 34px system-ui, 'DejaVu Sans', sans-serif";
  paint.textAlign = "center";
  paint.textBaseline = "middle";
  paint.fillText(String(number), 32, 34);
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  const sprite = new THREE.Sprite(
    new THREE.SpriteMaterial({map: texture, sizeAttenuation: false, depthTest: false, fog: false}));
  sprite.scale.setScalar(0.034);  // of the picture's height: legible from any distance
  sprite.center.set(0.5, -0.3);   // above the robot in the picture, even from above
  sprite.renderOrder = 2;
  return sprite;
}

class Robot {
  constructor(robot, parts) {
    this.team = robot.team;
    this.number = robot.number;
    this.group = new THREE.Group();
    this.parts = parts.map((part) => {
      const mesh = new THREE.Mesh(shapeOf(part), materialOf(part, robot.team));
      mesh.castShadow = part.collides;
      mesh.receiveShadow = part.collides;
      if (part.name === "head") mesh.add(visor(part.size[0]));
      this.group.add(mesh);
      return mesh;
    });
    this.label = label(robot.number, robot.team);
    this.group.add(this.label);
  }

  get position() { return this.parts[0].position; }  // of the torso

  move(numbers) {
    this.parts.forEach((mesh, index) => place(mesh, numbers, index * 7));
    this.label.position.copy(this.position);
    this.label.position.z += labelHeight;
  }
}

/** White with dark spots, so that one sees it roll. */
function ballTexture() {
  const canvas = document.createElement("canvas");
  canvas.width = 256;
  canvas.height = 128;
  const paint = canvas.getContext("2d");
  paint.fillStyle = "#ffffff";
  paint.fillRect(0, 0, 256, 128);
  paint.fillStyle = "#1d2227";
  for (const [row, count, shift] of [[6, 1, 0], [44, 5, 0], [84, 5, 25], [122, 1, 0]]) {
    for (let i = 0; i < count; ++i) {
      paint.beginPath();
      paint.ellipse(shift + (256 * (i + 0.5)) / count, row, count === 1 ? 128 : 13, 11, 0, 0, 7);
      paint.fill();
    }
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}

class Ball {
  constructor(radius) {
    this.group = new THREE.Group();
    this.mesh = new THREE.Mesh(
      new THREE.SphereGeometry(radius, 32, 20),
      new THREE.MeshLambertMaterial({map: ballTexture()}));
    this.mesh.castShadow = true;
    // The ball is 8 cm in a field of 30 m: a ring on the ground shows where it is.
    this.ring = new THREE.Mesh(
      new THREE.RingGeometry(0.13, 0.165, 40),
      new THREE.MeshBasicMaterial({color: 0xfff3b0, transparent: true, opacity: 0.85}));
    this.group.add(this.mesh, this.ring);
  }

  get position() { return this.mesh.position; }

  move(numbers) {
    place(this.mesh, numbers, 0);
    this.ring.position.set(this.position.x, this.position.y, 0.012);
  }
}

/** Robots and ball of one "scene" message. */
export class Players {
  constructor(scene) {
    this.group = new THREE.Group();
    this.ball = new Ball(scene.ball_radius);
    this.robots = scene.robots.map((robot) => new Robot(robot, scene.types[robot.type]));
    this.group.add(this.ball.group, ...this.robots.map((robot) => robot.group));
  }

  move(moment) {
    this.ball.move(moment.ball);
    this.robots.forEach((robot, index) => robot.move(moment.robots[index] ?? []));
  }
}
