// Camera, lights and floor. Pictures are drawn when something has changed, not all the time.
import {
  Box3, Color, DirectionalLight, HemisphereLight, Mesh, NeutralToneMapping, Object3D,
  PCFShadowMap, PerspectiveCamera, PlaneGeometry, Scene, ShadowMaterial, Sphere, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Grid } from "./grid.js";

Object3D.DEFAULT_UP.set(0, 0, 1);

const themes = {
  light: { background: 0xf4f5f7, grid: 0xb4bcc9, sky: 0xffffff, ground: 0xc9ccd4 },
  dark: { background: 0x14171c, grid: 0x465062, sky: 0xdfe8ff, ground: 0x30343d },
};

export class Stage {
  /** Throws where there is no WebGL. */
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.toneMapping = NeutralToneMapping;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(38, 1, 0.01, 200);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxPolarAngle = Math.PI * 0.52;
    this.controls.addEventListener("change", () => this.invalidate());
    this.sky = new HemisphereLight(0xffffff, 0xc0c4cc, 1.9);
    this.sky.position.set(0, 0, 1);
    this.sun = new DirectionalLight(0xffffff, 2.1);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.bias = -0.0002;
    this.floor = new Mesh(new PlaneGeometry(200, 200), new ShadowMaterial({ opacity: 0.22 }));
    this.floor.receiveShadow = true;
    this.floor.position.z = -0.002;
    this.grid = new Grid();
    this.scene.add(this.grid, this.sky, this.sun, this.sun.target, this.floor);
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.setTheme("light");
    this.resize();
  }

  setTheme(name) {
    const theme = themes[name];
    this.scene.background = new Color(theme.background);
    this.sky.color.set(theme.sky);
    this.sky.groundColor.set(theme.ground);
    this.grid.setColor(theme.grid);
    this.invalidate();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** Looks at all of the objects and points. */
  fit(objects, points = []) {
    const box = new Box3();
    for (const object of objects) box.expandByObject(object);
    for (const point of points) box.expandByPoint(point);
    if (box.isEmpty()) box.set(new Vector3(-1, -1, 0), new Vector3(1, 1, 1));
    const { center, radius } = box.getBoundingSphere(new Sphere());
    const narrow = Math.min(1, this.camera.aspect) * Math.tan((this.camera.fov * Math.PI) / 360);
    const distance = (0.92 * radius) / Math.sin(Math.atan(narrow));
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(new Vector3(1, -1.15, 0.75).normalize(), distance);
    this.controls.minDistance = radius / 50;
    this.controls.maxDistance = 20 * radius;
    const reach = 2 * radius;
    this.grid.focus(center, 4 * radius);
    Object.assign(this.sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1, far: 12 * radius });
    this.sun.shadow.camera.updateProjectionMatrix();
    this.sun.shadow.normalBias = radius / 400;
    this.sun.target.position.copy(center);
    this.sun.position.copy(center).addScaledVector(new Vector3(0.5, -0.65, 1.3).normalize(), 5 * radius);
    this.controls.update();
    this.invalidate();
  }

  invalidate() {
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = undefined;
      this.draw();
    });
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }
}
