/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The pass from the drawn points to the screen: eye-dome lighting and outlines.
 */

import {
  AlwaysDepth,
  BufferAttribute,
  BufferGeometry,
  Camera,
  DepthTexture,
  GLSL3,
  Mesh,
  NearestFilter,
  RawShaderMaterial,
  Scene,
  UnsignedIntType,
  Vector2,
  Vector3,
  WebGLRenderTarget,
} from 'three';
import type { PerspectiveCamera, WebGLRenderer } from 'three';
import { eyeDomeFragment, screenVertex } from './shaders/eye_dome.glsl';

export class EyeDomeLighting {
  enabled = true;
  readonly target: WebGLRenderTarget;
  private scene = new Scene();
  private camera = new Camera();
  private material: RawShaderMaterial;

  constructor() {
    const depthTexture = new DepthTexture(1, 1, UnsignedIntType);
    this.target = new WebGLRenderTarget(1, 1, {
      depthTexture,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
    });
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: screenVertex,
      fragmentShader: eyeDomeFragment,
      depthFunc: AlwaysDepth,
      uniforms: {
        picture: { value: this.target.texture },
        depth: { value: depthTexture },
        nearFar: { value: new Vector2() },
        strength: { value: 1 },
        radius: { value: 1 },
        plain: { value: false },
        background: { value: new Vector3(0.078, 0.09, 0.11) },
      },
    });
    // One triangle that covers the screen.
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    const mesh = new Mesh(geometry, this.material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
  }

  setSize(width: number, height: number): void {
    this.target.setSize(width, height);
  }

  draw(renderer: WebGLRenderer, camera: PerspectiveCamera, pixelRatio: number, shaded: boolean): void {
    const { uniforms } = this.material;
    uniforms.nearFar.value.set(camera.near, camera.far);
    uniforms.strength.value = this.enabled && shaded ? 1 : 0;
    uniforms.plain.value = !shaded;
    uniforms.radius.value = 1.4 * pixelRatio;
    renderer.setRenderTarget(null);
    renderer.render(this.scene, this.camera);
  }
}
