/** Where a scene is drawn: renderer, light, floor, camera; it draws only when something changed. */
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";
import type { CameraData } from "../physics/protocol";

/** A view that a picture was taken from: of its camera, in a frame of its proportions. */
export interface PictureView {
  camera: CameraData;
  /** Width over height. */
  aspect: number;
}

/** Milliseconds a drawing may take before the next ones are drawn coarser. */
const SLOW = 45;
const COARSEST = 0.6;

export class Stage {
  readonly scene = new THREE.Scene();
  readonly camera = new THREE.PerspectiveCamera(38, 1, 0.02, 30);
  readonly controls: OrbitControls;
  readonly renderer: THREE.WebGLRenderer;
  private readonly sun = new THREE.DirectionalLight(0xfff4e6, 2.2);
  private readonly floor: THREE.Mesh<THREE.CircleGeometry, THREE.ShadowMaterial>;
  private readonly watcher: ResizeObserver;
  private picture: PictureView | null = null;
  private asked = 0;
  private ratio = Math.min(window.devicePixelRatio || 1, 2);
  /** Called when the person moves the camera. */
  onMove: () => void = () => {};

  /** @throws Error if the browser gives no WebGL. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, powerPreference: "high-performance" });
    this.renderer.outputColorSpace = THREE.SRGBColorSpace;
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.camera.up.set(0, 0, 1);
    const room = new RoomEnvironment();
    room.rotation.x = Math.PI / 2;
    const baker = new THREE.PMREMGenerator(this.renderer);
    this.scene.environment = baker.fromScene(room, 0.04).texture;
    this.scene.environmentIntensity = 0.55;
    this.scene.environmentRotation.set(Math.PI / 2, 0, 0);
    baker.dispose();
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
    this.watcher.disconnect();
    this.controls.dispose();
    this.scene.environment?.dispose();
    this.floor.geometry.dispose();
    this.floor.material.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Draws once, at the next chance. */
  draw(): void {
    if (!this.asked) this.asked = requestAnimationFrame(() => this.render());
  }

  /** Looks at what is there, from in front and above, so that all of it is in view. */
  frame(root: THREE.Object3D, azimuth = -0.5, elevation = 0.5): void {
    const box = new THREE.Box3().setFromObject(root, false);
    if (box.isEmpty()) box.set(new THREE.Vector3(-0.5, -0.5, 0), new THREE.Vector3(0.5, 0.5, 1));
    const centre = box.getCenter(new THREE.Vector3());
    const radius = box.getSize(new THREE.Vector3()).length() / 2;
    this.light(centre, radius);
    this.picture = null;
    this.camera.fov = 38;
    const half = Math.min(this.camera.fov / 2, (Math.atan(Math.tan((this.camera.fov * Math.PI) / 360) * this.camera.aspect) * 180) / Math.PI);
    const far = (radius * 0.92) / Math.sin((half * Math.PI) / 180);
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

  /** Looks from above, or again from in front. */
  lookFrom(root: THREE.Object3D, side: "front" | "top"): void {
    this.frame(root, side === "top" ? 0 : -0.5, side === "top" ? 1.5 : 0.5);
  }

  /** Looks as the scene's picture does, until the person moves the camera. */
  enterPicture(view: PictureView, height: number): void {
    const { camera } = view;
    const turn = new THREE.Quaternion(camera.quaternion[1], camera.quaternion[2], camera.quaternion[3], camera.quaternion[0]);
    this.camera.position.set(...camera.position);
    const ahead = new THREE.Vector3(0, 0, -1).applyQuaternion(turn);
    // The orbit goes about the point of the view's middle that is as high as the tabletop.
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

  private light(centre: THREE.Vector3, radius: number): void {
    const span = Math.max(radius * 1.25, 0.6);
    this.sun.position.set(centre.x - 0.9, centre.y - 1.1, centre.z + 2.4);
    this.sun.target.position.copy(centre);
    this.sun.castShadow = true;
    const size = this.renderer.capabilities.maxTextureSize >= 4096 ? 2048 : 1024;
    this.sun.shadow.mapSize.set(size, size);
    Object.assign(this.sun.shadow.camera, { left: -span, right: span, top: span, bottom: -span, near: 0.1, far: 3 + 2 * span });
    this.sun.shadow.camera.updateProjectionMatrix();
    this.sun.shadow.bias = -0.0004;
    this.sun.shadow.normalBias = 0.008;
    this.sun.shadow.radius = 4;
  }

  /** Fits the field of view to the picture's frame, which lies whole in the canvas. */
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
    const width = Math.max(Math.round(box.width), 1);
    const height = Math.max(Math.round(box.height), 1);
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.fit();
    this.draw();
  }

  private render(): void {
    this.asked = 0;
    const begun = performance.now();
    if (!this.picture && this.controls.update()) this.draw();
    this.renderer.render(this.scene, this.camera);
    const took = performance.now() - begun;
    if (took > SLOW && this.ratio > COARSEST) {
      this.ratio = Math.max(this.ratio * 0.8, COARSEST);
      this.resize();
    }
  }
}
