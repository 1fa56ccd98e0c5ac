/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Draws the cloud when something changed, and fewer points while the camera moves.
 */

import { GLSL3, PerspectiveCamera, Points, RawShaderMaterial, Scene, Vector2, Vector3, Vector4, WebGLRenderer } from 'three';
import type { IUniform, Object3D, Texture } from 'three';
import { CloudGeometry } from './cloud_geometry';
import { Emitter } from './emitter';
import { EyeDomeLighting } from './eye_dome_lighting';
import type { InstanceTable } from './instance_table';
import { cloudFragment, cloudVertex } from './shaders/cloud.glsl';
import { idFragment, idVertex } from './shaders/id.glsl';

const REST = 140;
const LEAST_BUDGET = 120_000;
const MOST_BUDGET = 4_000_000;
/** Enough to see a room by, and quickly drawn even without a graphics card. */
const FIRST_LOOK = 200_000;

export interface Section {
  low: Vector3;
  high: Vector3;
  ceiling: number;
}

export class PointCloudView extends Emitter<{ frame: number; resized: void }> {
  readonly renderer: WebGLRenderer;
  readonly camera = new PerspectiveCamera(50, 1, 0.02, 1000);
  readonly lighting = new EyeDomeLighting();
  readonly size = new Vector2(1, 1);
  readonly uniforms: Record<string, IUniform>;
  /** Asked at each frame; true: the camera still moves. */
  animate: (seconds: number) => boolean = () => false;
  pointSize = 1;
  pointsShown = true;
  moving = false;
  private scene = new Scene();
  private idScene = new Scene();
  private overScene = new Scene();
  private requested = 0;
  private restTimer = 0;
  private pulseUntil = 0;
  private lastFrame = 0;
  private budget = 1_500_000;
  private slow = false;
  private arriving = false;
  private arrivalTimer = 0;
  arrivedPlaces = 0;
  frames = 0;

  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly cloud: CloudGeometry,
    private table: InstanceTable,
    hasColor: boolean,
    readonly up: Vector3,
    readonly spacing: () => number,
  ) {
    super();
    this.renderer = new WebGLRenderer({ canvas, antialias: false, alpha: false, powerPreference: 'high-performance' });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.autoClear = true;
    this.renderer.setClearColor(0x000000, 0);
    this.uniforms = {
      boxLow: { value: new Vector3(-Infinity, -Infinity, -Infinity).setScalar(-1e9) },
      boxHigh: { value: new Vector3().setScalar(1e9) },
      ceiling: { value: new Vector4(up.x, up.y, up.z, 1e9) },
      pointScale: { value: 1 },
      worldSize: { value: 0.01 },
      sizeLimits: { value: new Vector2(1, 16) },
      instanceColors: { value: null as Texture | null },
      classColors: { value: null as Texture | null },
      partColors: { value: null as Texture | null },
      hidesLabels: { value: true },
      ramp: { value: null as Texture | null },
      range: { value: new Vector2(0, 1) },
      mode: { value: 0 },
      hasColor: { value: hasColor },
      dimmed: { value: false },
      pulse: { value: 0 },
    };
    const material = (vertexShader: string, fragmentShader: string): RawShaderMaterial =>
      new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms: this.uniforms });
    for (const [scene, shader] of [
      [this.scene, material(cloudVertex, cloudFragment)],
      [this.idScene, material(idVertex, idFragment)],
    ] as const) {
      const points = new Points(cloud.geometry, shader);
      points.frustumCulled = false;
      points.matrixAutoUpdate = false;
      scene.add(points);
    }
    this.camera.up.copy(up);
    table.on('changed', () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
    this.resize();
  }

  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  get busy(): boolean {
    return this.requested !== 0 || this.moving || this.arriving || this.pulseUntil > 0;
  }

  /** How many places are drawn now: all that are there, or a thinned scan while places arrive or the camera moves. */
  get drawnPlaces(): number {
    if (!this.pointsShown) return 0;
    const most = this.moving ? this.budget : Infinity;
    return Math.min(this.arrivedPlaces, this.arriving ? Math.min(FIRST_LOOK, most) : most);
  }

  /** So many places are there now. */
  arrive(places: number): void {
    this.arrivedPlaces = places;
    this.arriving = true;
    window.clearTimeout(this.arrivalTimer);
    this.arrivalTimer = window.setTimeout(() => {
      this.arriving = false;
      this.invalidate();
    }, REST);
    this.invalidate();
  }

  /** Something more to draw, which picking does not see. */
  addToPicture(object: Object3D): void {
    this.scene.add(object);
  }

  setSection(section: Section): void {
    this.uniforms.boxLow.value.copy(section.low);
    this.uniforms.boxHigh.value.copy(section.high);
    this.uniforms.ceiling.value.w = section.ceiling;
    this.invalidate();
  }

  /** Shows a short pulse of what is marked. */
  pulse(): void {
    this.pulseUntil = performance.now() + 900;
    this.invalidate();
  }

  invalidate(): void {
    if (this.requested === 0) this.requested = requestAnimationFrame((now) => this.frame(now));
  }

  /** Something that lies over the shaded points, hidden by those before it. */
  addOver(object: Object3D): void {
    this.overScene.add(object);
  }

  private resize(): void {
    const box = this.canvas.parentElement!.getBoundingClientRect();
    this.size.set(Math.max(1, box.width), Math.max(1, box.height));
    this.renderer.setSize(this.size.x, this.size.y);
    this.camera.aspect = this.size.x / this.size.y;
    this.camera.updateProjectionMatrix();
    this.lighting.setSize(Math.round(this.size.x * this.pixelRatio), Math.round(this.size.y * this.pixelRatio));
    this.emit('resized', undefined);
    this.invalidate();
  }

  private frame(now: number): void {
    this.requested = 0;
    const seconds = Math.min(0.3, (now - this.lastFrame) / 1000);
    const continued = now - this.lastFrame < 3000;
    const moved = this.animate(this.moving && continued ? seconds : 1 / 60);
    if (moved) {
      if (this.moving && continued) this.adaptBudget(now - this.lastFrame);
      this.moving = true;
      window.clearTimeout(this.restTimer);
      this.restTimer = window.setTimeout(() => {
        this.moving = false;
        this.invalidate();
      }, REST);
    }
    this.lastFrame = now;
    this.draw(now);
    if (moved || this.pulseUntil > 0) this.invalidate();
  }

  /** Thinner where frames take long, denser where there is time. */
  private adaptBudget(milliseconds: number): void {
    this.slow = milliseconds > (this.slow ? 30 : 60);
    if (milliseconds > 45) this.budget = Math.max(LEAST_BUDGET, this.budget * 0.75);
    else if (milliseconds < 22) this.budget = Math.min(MOST_BUDGET, this.budget * 1.1);
  }

  /** Sets what both passes need: sizes of the points, tables, and how many are drawn. */
  prepare(): void {
    const { uniforms } = this;
    uniforms.instanceColors.value = this.table.instances;
    uniforms.classColors.value = this.table.classes;
    const tangent = Math.tan((this.camera.fov * Math.PI) / 360);
    uniforms.pointScale.value = (this.size.y * this.pixelRatio) / (2 * tangent);
    const drawn = this.drawnPlaces;
    // Fewer points are drawn larger, so that surfaces stay closed.
    const thinning = Math.min(2.5, Math.sqrt(this.cloud.places / Math.max(1, drawn)));
    uniforms.worldSize.value = 1.7 * this.spacing() * this.pointSize * thinning;
    uniforms.sizeLimits.value.set(Math.max(1, Math.min(this.pointSize, 2)) * this.pixelRatio, 15 * this.pixelRatio);
    uniforms.dimmed.value = this.cloud.marked(1).length > 0;
    this.cloud.geometry.setDrawRange(0, drawn);
  }

  private draw(now: number): void {
    const left = this.pulseUntil - now;
    if (left <= 0) this.pulseUntil = 0;
    this.uniforms.pulse.value = left > 0 ? 0.5 + 0.5 * Math.cos((left / 900) * 4 * Math.PI) : 0;
    this.prepare();
    this.renderer.setRenderTarget(this.lighting.target);
    this.renderer.render(this.scene, this.camera);
    // Where frames take long, the shading waits until the camera rests.
    const shaded = !(this.moving && this.slow);
    this.lighting.draw(this.renderer, this.camera, this.pixelRatio, shaded);
    this.drawOver();
    this.frames++;
    this.emit('frame', now);
  }

  private drawOver(): void {
    this.renderer.autoClear = false;
    this.renderer.render(this.overScene, this.camera);
    this.renderer.autoClear = true;
  }

  /** Draws numbers of places instead of colors into the target that is set. */
  drawIds(): void {
    this.prepare();
    this.renderer.render(this.idScene, this.camera);
  }
}
