// SPDX-License-Identifier: BSD-3-Clause
// Where the picture is taken from: orbit by hand around a target that can follow ball or robot.
import * as THREE from "three";

import {OrbitControls} from "./lib/OrbitControls.js";

const slant = new THREE.Vector3(0, -0.72, 0.62).normalize();  // from the target to the camera
const above = new THREE.Vector3(0, -0.001, 1).normalize();
const closeUp = {
  robot: 2.3,
  ball: 1.6
};                 // m from what is followed
const chase = 10;  // 1/s: how fast the target catches up with what it follows

export class View {
  constructor(canvas) {
    this.camera = new THREE.PerspectiveCamera(40, 1, 0.05, 300);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxPolarAngle = Math.PI / 2 - 0.02;  // never below the grass
    this.controls.minDistance = 0.4;
    this.controls.maxDistance = 90;
    this.controls.addEventListener("start", () => (this.touched = true));
    this.extent = [30, 20];
    this.name = "overview";
    this.follow = null;
    this.touched = false;
  }

  /** Full size of what the overview shows, about the field's centre. */
  setExtent(extent) {
    const same = extent[0] === this.extent[0] && extent[1] === this.extent[1];
    this.extent = extent;
    if (!same) this.reframe();
  }

  resize(aspect) {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    this.reframe();
  }

  /** "overview", "top", or any other name with a function that gives the position to follow. */
  choose(name, follow = null) {
    const fresh = !this.follow && follow;
    this.name = name;
    this.follow = follow;
    this.touched = false;
    this.reframe();
    if (!follow) return;
    const at = follow();
    const offset = this.camera.position.clone().sub(this.controls.target);
    if (fresh) offset.copy(slant).multiplyScalar(name === "ball" ? closeUp.ball : closeUp.robot);
    this.controls.target.copy(at);
    this.camera.position.copy(at).add(offset);
  }

  update(seconds) {
    if (this.follow) {
      const step = this.follow().clone().sub(this.controls.target);
      step.multiplyScalar(1 - Math.exp(-chase * seconds));
      this.controls.target.add(step);
      this.camera.position.add(step);
    }
    this.controls.update();
  }

  /** Steps back until the extent fits the picture, unless the user has taken the camera over. */
  reframe() {
    if (this.follow || this.touched) return;
    const direction = this.name === "top" ? above : slant;
    const [x, y] = [this.extent[0] / 2, this.extent[1] / 2];
    const corners = [[-x, -y], [x, -y], [x, y], [-x, y]];
    this.controls.target.set(0, 0, 0);
    for (let distance = 2; distance < 80; distance *= 1.02) {
      this.camera.position.copy(direction).multiplyScalar(distance);
      this.camera.lookAt(0, 0, 0);
      this.camera.updateMatrixWorld();
      const fits = corners.every(([cx, cy]) => {
        const p = new THREE.Vector3(cx, cy, 0).project(this.camera);
        return Math.abs(p.x) < 0.94 && p.y < 0.8 &&
          p.y > -0.84;  // below the board, above the buttons
      });
      if (fits) break;
    }
    this.controls.update();
  }
}
