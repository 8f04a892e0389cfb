/** Rendering of a scene: renderer, light, floor, camera; it draws only after changes. */
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { CameraData } from "../physics/protocol";

/** The view of a picture: its camera, in a frame with its aspect ratio. */
export interface PictureView {
  camera: CameraData;
  /** Width over height. */
  aspect: number;
}

/** Drawing time in milliseconds above which resolution is reduced. */
const SLOW = 45;
const COARSEST = 0.6;
/** Milliseconds without a change after which a reduced drawing is repeated in full resolution. */
const STILL = 250;

export class Stage {
  readonly scene = new THREE.Scene();
  readonly camera = new THREE.PerspectiveCamera(38, 1, 0.02, 30);
  readonly controls: OrbitControls;
  readonly renderer: THREE.WebGLRenderer;
  private readonly sun = new THREE.DirectionalLight(0xfff4e6, 2.3);
  private readonly floor: THREE.Mesh<THREE.CircleGeometry, THREE.ShadowMaterial>;
  private readonly watcher: ResizeObserver;
  private picture: PictureView | null = null;
  private asked = 0;
  private readonly small = ((navigator as { deviceMemory?: number }).deviceMemory ?? 8) <= 2;
  private readonly finest = this.small ? 1 : Math.min(window.devicePixelRatio || 1, 2);
  private ratio = this.finest;
  private still = 0;
  /** Called when the person moves the camera. */
  onMove: () => void = () => {};

  /** @throws Error if the browser does not provide WebGL. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !this.small, alpha: true, powerPreference: "high-performance" });
    this.renderer.outputColorSpace = THREE.SRGBColorSpace;
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.camera.up.set(0, 0, 1);
    // No environment map: blurring one takes seconds without a graphics card.
    const sky = new THREE.HemisphereLight(0xf4f7ff, 0xb8a894, 1.9);
    sky.position.set(0, 0, 1);
    const fill = new THREE.DirectionalLight(0xdfe8ff, 0.55);
    fill.position.set(1.4, 0.6, 1.1);
    this.scene.add(sky, fill);
    this.scene.add(this.sun, this.sun.target);
    this.floor = new THREE.Mesh(new THREE.CircleGeometry(6, 64), new THREE.ShadowMaterial({ opacity: 0.22 }));
    this.floor.receiveShadow = true;
    this.scene.add(this.floor);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.maxPolarAngle = Math.PI * 0.495;
    this.controls.addEventListener("start", () => this.leavePicture());
    this.controls.addEventListener("change", () => this.draw());
    this.watcher = new ResizeObserver(() => this.resize());
    this.watcher.observe(canvas.parentElement ?? canvas);
    this.resize();
  }

  dispose(): void {
    cancelAnimationFrame(this.asked);
    clearTimeout(this.still);
    this.watcher.disconnect();
    this.controls.dispose();
    this.floor.geometry.dispose();
    this.floor.material.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Draws once, at the next opportunity. */
  draw(): void {
    if (!this.asked) this.asked = requestAnimationFrame(() => this.render());
  }

  /**
   * Frames all objects higher than `lowest` metres, from the front and above.
   *
   * @param azimuth - 0 looks along +y, a positive one moves the camera towards +x.
   */
  frame(root: THREE.Object3D, lowest: number, azimuth = -0.45, elevation = 0.55): void {
    const box = new THREE.Box3().setFromObject(root, false);
    if (box.isEmpty()) box.set(new THREE.Vector3(-0.5, -0.5, 0), new THREE.Vector3(0.5, 0.5, 1));
    const whole = box.clone();
    box.min.z = Math.min(Math.max(box.min.z, lowest), box.max.z - 0.05);
    const centre = box.getCenter(new THREE.Vector3());
    const radius = box.getSize(new THREE.Vector3()).length() / 2;
    this.light(whole);
    this.picture = null;
    this.camera.fov = 38;
    const half = Math.min(this.camera.fov / 2, (Math.atan(Math.tan((this.camera.fov * Math.PI) / 360) * this.camera.aspect) * 180) / Math.PI);
    const far = (radius * 0.86) / Math.sin((half * Math.PI) / 180);
    const out = new THREE.Vector3(
      Math.sin(azimuth) * Math.cos(elevation),
      -Math.cos(azimuth) * Math.cos(elevation),
      Math.sin(elevation),
    );
    this.camera.position.copy(centre).addScaledVector(out, far);
    this.controls.target.copy(centre);
    this.controls.maxDistance = Math.max(12, 4 * radius);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  /** The camera's position and target, to restore it elsewhere. */
  get view(): number[] {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  set view(numbers: number[]) {
    this.leavePicture();
    this.camera.position.fromArray(numbers, 0);
    this.controls.target.fromArray(numbers, 3);
    this.controls.update();
    this.draw();
  }

  /** Rotates the camera about its target, radians. */
  turn(azimuth: number, polar: number): void {
    this.leavePicture();
    const out = this.camera.position.clone().sub(this.controls.target);
    const turned = new THREE.Spherical().setFromVector3(new THREE.Vector3(out.x, out.z, -out.y));
    turned.theta += azimuth;
    turned.phi = Math.min(Math.max(turned.phi + polar, 0.05), this.controls.maxPolarAngle);
    const to = new THREE.Vector3().setFromSpherical(turned);
    this.camera.position.copy(this.controls.target).add(new THREE.Vector3(to.x, -to.z, to.y));
    this.controls.update();
    this.draw();
  }

  /** Scales the distance of the camera by `factor`. */
  zoom(factor: number): void {
    this.leavePicture();
    const out = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(out);
    this.controls.update();
    this.draw();
  }

  /** Uses the view of the scene's picture, until the person moves the camera. */
  enterPicture(view: PictureView, height: number): void {
    const { camera } = view;
    const turn = new THREE.Quaternion(camera.quaternion[1], camera.quaternion[2], camera.quaternion[3], camera.quaternion[0]);
    this.camera.position.set(...camera.position);
    const ahead = new THREE.Vector3(0, 0, -1).applyQuaternion(turn);
    // The orbit centre is the point in the middle of the view at the height of the table top.
    const far = ahead.z < -0.05 ? (height - camera.position[2]) / ahead.z : 1.2;
    this.controls.target.copy(this.camera.position).addScaledVector(ahead, Math.min(Math.max(far, 0.3), 4));
    this.picture = view;
    this.fit();
    this.controls.update();
    this.camera.quaternion.copy(turn);
    this.draw();
  }

  private leavePicture(): void {
    if (!this.picture) return;
    this.picture = null;
    this.onMove();
  }

  private light(box: THREE.Box3): void {
    const centre = box.getCenter(new THREE.Vector3());
    const span = Math.max(box.getSize(new THREE.Vector3()).length() * 0.6, 0.5);
    this.sun.position.set(centre.x - 0.9, centre.y - 1.1, centre.z + 2.4);
    this.sun.target.position.copy(centre);
    this.sun.castShadow = true;
    const size = this.small || this.renderer.capabilities.maxTextureSize < 4096 ? 1024 : 2048;
    this.sun.shadow.mapSize.set(size, size);
    Object.assign(this.sun.shadow.camera, { left: -span, right: span, top: span, bottom: -span, near: 0.1, far: 3 + 2 * span });
    this.sun.shadow.camera.updateProjectionMatrix();
    this.sun.shadow.bias = -0.0006;
    this.sun.shadow.normalBias = 0.0015;
    this.sun.shadow.radius = 3;
  }

  /** Adapts the field of view so that the picture's frame lies entirely in the canvas. */
  private fit(): void {
    if (!this.picture) return;
    const { camera, aspect } = this.picture;
    const half = Math.tan((camera.fovy * Math.PI) / 360);
    const wider = this.camera.aspect < aspect ? (half * aspect) / this.camera.aspect : half;
    this.camera.fov = (Math.atan(wider) * 360) / Math.PI;
    this.camera.updateProjectionMatrix();
  }

  private resize(): void {
    const box = (this.canvas.parentElement ?? this.canvas).getBoundingClientRect();
    this.camera.aspect = Math.max(box.width, 1) / Math.max(box.height, 1);
    this.camera.updateProjectionMatrix();
    this.fit();
    this.setRatio(this.ratio);
    this.draw();
  }

  private setRatio(ratio: number): void {
    const box = (this.canvas.parentElement ?? this.canvas).getBoundingClientRect();
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(Math.max(Math.round(box.width), 1), Math.max(Math.round(box.height), 1), false);
  }

  private render(): void {
    this.asked = 0;
    clearTimeout(this.still);
    const begun = performance.now();
    if (!this.picture && this.controls.update()) this.draw();
    if (this.renderer.getPixelRatio() !== this.ratio) this.setRatio(this.ratio);
    this.renderer.render(this.scene, this.camera);
    if (performance.now() - begun > SLOW) this.ratio = Math.max(this.ratio * 0.8, COARSEST);
    if (this.ratio < this.finest) this.still = window.setTimeout(() => this.renderFine(), STILL);
  }

  private renderFine(): void {
    this.setRatio(this.finest);
    this.renderer.render(this.scene, this.camera);
  }
}
