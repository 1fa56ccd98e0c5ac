/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The camera: orbit about what is under the cursor, pan, zoom to the cursor, fly, and fly to a place.
 */

import CameraControls from 'camera-controls';
import {
  Box3,
  MathUtils,
  Matrix4,
  Quaternion,
  Raycaster,
  Sphere,
  Spherical,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import type { PointCloudView } from './point_cloud_view';

CameraControls.install({
  THREE: { Vector2, Vector3, Vector4, Quaternion, Matrix4, Spherical, Box3, Sphere, Raycaster, MathUtils } as never,
});

const { ACTION } = CameraControls;

export class Camera {
  readonly controls: CameraControls;
  private center: Vector3;
  private diagonal: number;
  private flying = 0;
  private lastWheel = 0;

  constructor(
    private view: PointCloudView,
    bounds: Box3,
    private keysDown: Set<string>,
    private pick: (x: number, y: number) => Vector3 | null,
  ) {
    const { camera, canvas } = view;
    this.center = bounds.getCenter(new Vector3());
    this.diagonal = Math.max(0.1, bounds.getSize(new Vector3()).length());
    camera.near = this.diagonal / 2500;
    camera.far = this.diagonal * 12;
    camera.updateProjectionMatrix();
    // Before the listeners of the controls, so that they find the buttons as the keys want them.
    canvas.addEventListener('pointerdown', (event) => this.pointerDown(event));
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: true });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    this.controls = new CameraControls(camera, canvas);
    this.controls.smoothTime = this.still ? 0.01 : 0.22;
    this.controls.draggingSmoothTime = this.still ? 0.01 : 0.04;
    this.controls.dollyToCursor = true;
    this.controls.infinityDolly = true;
    this.controls.minDistance = this.diagonal / 500;
    this.controls.maxDistance = this.diagonal * 8;
    this.controls.mouseButtons.right = ACTION.TRUCK;
    this.controls.mouseButtons.middle = ACTION.TRUCK;
    this.controls.addEventListener('update', () => this.view.invalidate());
    for (const name of ['controlstart', 'control', 'transitionstart', 'wake'] as const) {
      this.controls.addEventListener(name, () => this.view.invalidate());
    }
    // Flying begins with a key; the frames after it come by themselves.
    window.addEventListener('keydown', () => keysDown.size > 0 && view.invalidate());
    view.animate = (seconds) => this.animate(seconds);
  }

  /** The person wants no motion that they don't make themselves. */
  private get still(): boolean {
    return window.matchMedia('(prefers-reduced-motion: reduce)').matches;
  }

  get isFlying(): boolean {
    return this.flying > 0;
  }

  set enabled(value: boolean) {
    this.controls.enabled = value;
  }

  private pointerDown(event: PointerEvent): void {
    if (!this.controls.enabled) return;
    const pans = event.shiftKey || event.button !== 0;
    this.controls.mouseButtons.left = event.shiftKey ? ACTION.TRUCK : ACTION.ROTATE;
    const point = this.pick(event.offsetX, event.offsetY);
    this.straighten(point ? this.depthOf(point) : undefined);
    if (point && !pans) this.controls.setOrbitPoint(point.x, point.y, point.z);
  }

  private wheel(event: WheelEvent): void {
    // The distance of what is under the cursor sets the step; it holds for one turn of the wheel.
    const now = performance.now();
    if (now - this.lastWheel > 250) {
      const point = this.pick(event.offsetX, event.offsetY);
      this.straighten(point ? this.depthOf(point) : undefined);
    }
    this.lastWheel = now;
  }

  private forward(): Vector3 {
    return this.view.camera.getWorldDirection(new Vector3());
  }

  private depthOf(point: Vector3): number {
    return point.clone().sub(this.view.camera.position).dot(this.forward());
  }

  /** Puts the target before the camera, at this depth, without a change of the picture. */
  private straighten(depth = this.controls.distance): void {
    const eye = this.view.camera.position.clone();
    const target = eye.clone().addScaledVector(this.forward(), Math.max(depth, this.controls.minDistance * 1.01));
    void this.controls.setFocalOffset(0, 0, 0, false);
    void this.controls.setLookAt(eye.x, eye.y, eye.z, target.x, target.y, target.z, false);
  }

  private async fly(eye: Vector3, target: Vector3, smooth = true): Promise<void> {
    this.straighten();
    this.flying++;
    this.view.invalidate();
    await this.controls.setLookAt(eye.x, eye.y, eye.z, target.x, target.y, target.z, smooth && !this.still);
    this.flying--;
    this.view.invalidate();
  }

  /** A basis with `up` as its third axis. */
  private axes(): [Vector3, Vector3, Vector3] {
    const up = this.view.up.clone();
    const side = Math.abs(up.x) < 0.9 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
    const east = side.sub(up.clone().multiplyScalar(side.dot(up))).normalize();
    return [east, up.clone().cross(east), up];
  }

  /** The direction from a target to the camera. */
  direction(azimuth: number, elevation: number): Vector3 {
    const [east, north, up] = this.axes();
    return east
      .multiplyScalar(Math.cos(azimuth) * Math.cos(elevation))
      .addScaledVector(north, Math.sin(azimuth) * Math.cos(elevation))
      .addScaledVector(up, Math.sin(elevation));
  }

  /** From which side the camera looks now. */
  get azimuth(): number {
    const [east, north] = this.axes();
    const back = this.forward().negate();
    const [x, y] = [back.dot(east), back.dot(north)];
    return Math.hypot(x, y) < 1e-3 ? -Math.PI / 3 : Math.atan2(y, x);
  }

  /** How far away a ball of this radius fills the smaller side of the picture. */
  distanceFor(radius: number): number {
    const { camera } = this.view;
    const half = Math.min((camera.fov / 2) * MathUtils.DEG2RAD, Math.atan(Math.tan((camera.fov / 2) * MathUtils.DEG2RAD) * camera.aspect));
    return radius / Math.sin(half);
  }

  lookFrom(target: Vector3, direction: Vector3, distance: number, smooth = true): Promise<void> {
    return this.fly(target.clone().addScaledVector(direction, distance), target, smooth);
  }

  home(smooth = true): Promise<void> {
    const target = this.center.clone().addScaledVector(this.view.up, -0.05 * this.diagonal);
    return this.lookFrom(target, this.direction(-Math.PI / 2.7, 0.98), this.distanceFor(this.diagonal * 0.46), smooth);
  }

  top(): Promise<void> {
    const direction = this.direction(-Math.PI / 2, Math.PI / 2 - 1e-3);
    return this.lookFrom(this.center.clone(), direction, this.distanceFor(this.diagonal * 0.46));
  }

  /** Looks at a point from where the camera is, nearer. */
  focus(point: Vector3): Promise<void> {
    const { camera } = this.view;
    const distance = Math.max(this.controls.minDistance * 4, 0.45 * camera.position.distanceTo(point));
    return this.lookFrom(point, this.forward().negate(), distance);
  }

  /** One step of an arrow key. */
  turn(right: number, up: number): void {
    this.straighten();
    void this.controls.rotate(right * 0.2, up * 0.14, true);
    this.view.invalidate();
  }

  zoom(factor: number): void {
    void this.controls.dollyTo(this.controls.distance * factor, true);
    this.view.invalidate();
  }

  private animate(seconds: number): boolean {
    let moved = this.flyByKeys(seconds);
    if (this.controls.update(seconds)) moved = true;
    return moved;
  }

  private flyByKeys(seconds: number): boolean {
    const down = (code: string): number => (this.keysDown.has(code) ? 1 : 0);
    const ahead = down('KeyW') - down('KeyS');
    const right = down('KeyD') - down('KeyA');
    const rise = down('KeyE') - down('KeyQ');
    const any = ahead !== 0 || right !== 0 || rise !== 0;
    if (!any) return false;
    const fast = this.keysDown.has('ShiftLeft') || this.keysDown.has('ShiftRight') ? 3 : 1;
    const step = seconds * fast * this.diagonal * 0.16;
    const move = this.forward().multiplyScalar(ahead * step);
    const sideways = this.forward().cross(this.view.up).normalize();
    move.addScaledVector(sideways, right * step).addScaledVector(this.view.up, rise * step);
    this.straighten();
    const target = this.controls.getTarget(new Vector3(), false).add(move);
    void this.controls.moveTo(target.x, target.y, target.z, false);
    return true;
  }
}
