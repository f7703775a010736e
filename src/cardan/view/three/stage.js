// The stage: renderer, light, floor, and a camera that frames what moves.

import {
  Color, DirectionalLight, DoubleSide, HemisphereLight, Mesh, LinearToneMapping, PCFShadowMap, PerspectiveCamera, PlaneGeometry,
  PMREMGenerator, Quaternion, Raycaster, Scene, ShaderMaterial, ShadowMaterial, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";

const Z = new Vector3(0, 0, 1), FIELD = 24; // degrees, of the smaller side

export class Stage {
  constructor(canvas, data, changed) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    // others crush what is dark
    this.renderer.toneMapping = LinearToneMapping;
    this.renderer.toneMappingExposure = 0.8;
    this.scene = new Scene();
    this.up = new Vector3(...data.up);
    this.surround();
    this.normal = data.normal && new Vector3(...data.normal);
    this.camera = new PerspectiveCamera(FIELD, 1, 0.01, 100);
    this.camera.up.copy(this.up);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", changed);
    this.scene.add(new HemisphereLight(0xffffff, 0x9aa4b6, 0.2));
    const fill = new DirectionalLight(0xe4ecff, 0.85), rim = new DirectionalLight(0xffffff, 1.6);
    this.sun = new DirectionalLight(0xfffaf3, 2.1);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.bias = -0.0006;
    this.sun.shadow.radius = 4;
    Object.assign(this, { fill, rim });
    this.scene.add(fill, rim, this.sun, this.sun.target);
    this.floor = data.floor === null ? null : this.paved();
  }

  // a room with lamps: what is dark shows its shape by what it reflects
  surround() {
    const room = new PMREMGenerator(this.renderer);
    this.scene.environment = room.fromScene(new RoomEnvironment(), 0.04).texture;
    this.scene.environmentIntensity = 0.38;
    this.scene.environmentRotation.setFromQuaternion(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), this.up));
    room.dispose();
  }

  paved() {
    const plane = new Mesh(new PlaneGeometry(1, 1), new ShadowMaterial({ opacity: 0.25 }));
    plane.receiveShadow = true;
    // a grid of two meshes that fades with the distance
    this.grid = new ShaderMaterial({
      transparent: true, depthWrite: false, side: DoubleSide,
      uniforms: { ink: { value: new Color() }, cell: { value: 1 }, far: { value: 5 }, middle: { value: new Vector2() } },
      vertexShader: "varying vec2 w; void main() { w = (modelMatrix * vec4(position, 1.)).xy; w = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.); }",
      fragmentShader: `varying vec2 w; uniform vec3 ink; uniform vec2 middle; uniform float cell, far;
        float line(float c) { vec2 g = abs(fract(w / c - .5) - .5) / fwidth(w / c); return 1. - min(min(g.x, g.y) / 1.2, 1.); }
        // squares, averaged over a pixel
        float squares(vec2 c) { vec2 d = fwidth(c) + 1e-4, i = 2. * (abs(fract((c - .5 * d) / 2.) - .5) - abs(fract((c + .5 * d) / 2.) - .5)) / d; return .5 - .5 * i.x * i.y; }
        void main() { float a = max(max(.09 * squares(w / cell), .2 * line(cell)), .42 * line(5. * cell)) * (1. - smoothstep(.25 * far, far, distance(w, middle)));
          if (a < .004) discard; gl_FragColor = vec4(ink, a); }`,
    });
    const grid = new Mesh(new PlaneGeometry(1, 1), this.grid);
    plane.quaternion.copy(new Quaternion().setFromUnitVectors(Z, this.up));
    grid.quaternion.copy(plane.quaternion);
    this.scene.add(plane, grid);
    return { plane, grid };
  }

  // cloud: points that the picture has to hold
  frame(cloud, floor) {
    this.cloud = cloud;
    const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
    for (const p of cloud) { low.min(p); high.max(p); }
    this.center = new Vector3().addVectors(low, high).multiplyScalar(0.5);
    this.size = Math.max(...new Vector3().subVectors(high, low).toArray(), 1e-9);
    const size = this.size;
    Object.assign(this.sun.shadow.camera, { left: -1.4 * size, right: 1.4 * size, top: 1.4 * size, bottom: -1.4 * size, near: 0.05 * size, far: 8 * size });
    this.sun.shadow.normalBias = 0.01 * size;
    const side = this.side();
    const slant = side.clone().multiplyScalar(1.3).addScaledVector(new Vector3().crossVectors(this.up, side), -0.9).addScaledVector(this.up, 2);
    this.sun.position.copy(this.center).addScaledVector(slant, 1.5 * size);
    this.sun.target.position.copy(this.center);
    this.fill.position.copy(slant.clone().reflect(this.up).negate());
    // from behind: edges stand out against what is behind them
    this.rim.position.copy(side).multiplyScalar(-1).addScaledVector(new Vector3().crossVectors(this.up, side), 0.5).addScaledVector(this.up, 0.7);
    if (this.floor) this.pave(floor);
  }

  pave(height) {
    this.height = height;
    const size = this.size, on = this.center.clone().addScaledVector(this.up, height - this.center.dot(this.up));
    const { plane, grid } = this.floor, cell = 10 ** Math.floor(Math.log10(size)) / (size / 10 ** Math.floor(Math.log10(size)) < 2 ? 4 : size / 10 ** Math.floor(Math.log10(size)) < 5 ? 2 : 1);
    for (const mesh of [plane, grid]) { mesh.position.copy(on).addScaledVector(this.up, mesh === plane ? -0.002 * size : -0.001 * size); mesh.scale.setScalar(1); }
    plane.geometry = new PlaneGeometry(40 * size, 40 * size);
    grid.geometry = plane.geometry;
    this.grid.uniforms.cell.value = cell;
    this.cell = cell;
    this.grid.uniforms.far.value = 4.5 * size;
  }

  // the direction from which the scene is looked at when nobody says otherwise
  side() {
    if (this.normal) {
      // from the side, a little from above; where the plane is level, from the reader's side of it
      const level = Math.abs(this.normal.dot(this.up)) > 0.99;
      return level ? this.normal.clone().add(new Vector3(0, -0.3, 0)).normalize() : this.normal.clone().addScaledVector(this.up, 0.12).normalize();
    }
    const x = new Vector3(1, 0, 0).addScaledVector(this.up, -this.up.x);
    if (x.length() < 0.1) x.set(0, 0, 1);
    x.normalize();
    const back = new Vector3().crossVectors(x, this.up); // -y where z points up
    return x.multiplyScalar(0.7).addScaledVector(back, 0.7).addScaledVector(this.up, 0.33).normalize();
  }

  // looks from a direction so that the cloud fills the picture
  look(from = this.side(), upward = this.up) {
    const back = from.clone().normalize();
    let up = upward.clone().addScaledVector(back, -upward.dot(back));
    if (up.length() < 1e-3) up = Math.abs(back.y) < 0.9 ? new Vector3(0, 1, 0) : new Vector3(1, 0, 0);
    up.addScaledVector(back, -up.dot(back)).normalize();
    const right = new Vector3().crossVectors(up, back), tan = Math.tan((this.camera.fov * Math.PI) / 360), wide = tan * this.camera.aspect;
    const target = this.center.clone(), d = new Vector3();
    let distance = this.size;
    // the headline and the buttons stand in the topmost pixels
    const bar = "bare" in document.body.dataset ? 0 : 46;
    const head = tan * (1 - 2 * Math.min(0.2, bar / (this.canvas.clientHeight || 600)));
    for (let round = 0; round < 4; round++) {
      let [left, most, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
      distance = 1e-9;
      for (const p of this.cloud) {
        d.subVectors(p, target);
        const [x, y, z] = [d.dot(right), d.dot(up), d.dot(back)];
        distance = Math.max(distance, Math.abs(x) / wide + z, y / head + z, -y / tan + z);
        left = Math.min(left, x); most = Math.max(most, x); low = Math.min(low, y); high = Math.max(high, y);
      }
      if (round < 3) target.addScaledVector(right, (left + most) / 2).addScaledVector(up, (low / tan + high / head) / (1 / tan + 1 / head));
    }
    distance = Math.max(1.12 * distance, 0.2 * this.size);
    // straight from above a camera has no upward direction of its own
    if (Math.abs(back.dot(this.up)) > 0.9999) back.addScaledVector(up, -2e-4).normalize();
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(back, distance);
    this.camera.near = Math.max(0.004 * this.size, 0.01 * distance);
    this.camera.far = distance + 60 * this.size;
    this.controls.minDistance = 0.05 * this.size;
    this.controls.maxDistance = 40 * Math.max(distance, this.size);
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  orbit(azimuth, elevation) {
    const arm = new Vector3().subVectors(this.camera.position, this.controls.target);
    const right = new Vector3().crossVectors(this.up, arm).normalize(), angle = arm.angleTo(this.up);
    const tilt = Math.min(Math.max(angle - elevation, 0.02), Math.PI - 0.02) - angle;
    arm.applyAxisAngle(right, tilt).applyAxisAngle(this.up, azimuth);
    this.camera.position.addVectors(this.controls.target, arm);
    this.controls.update();
  }

  shift(x, y) {
    const reach = this.camera.position.distanceTo(this.controls.target), move = new Vector3();
    move.addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 0), x * reach).addScaledVector(new Vector3().setFromMatrixColumn(this.camera.matrix, 1), y * reach);
    this.carry(move);
  }

  carry(move) {
    this.camera.position.add(move);
    this.controls.target.add(move);
    this.controls.update();
  }

  zoom(factor) {
    const arm = new Vector3().subVectors(this.camera.position, this.controls.target).multiplyScalar(factor);
    this.camera.position.addVectors(this.controls.target, arm);
    this.controls.update();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    // the field of view belongs to the smaller side
    const half = Math.tan((FIELD * Math.PI) / 360);
    this.camera.fov = (360 / Math.PI) * Math.atan(half * Math.max(1, height / width));
    this.camera.updateProjectionMatrix();
  }

  color(css) {
    this.renderer.setClearColor(0, 0);
    if (!this.floor) return;
    this.grid.uniforms.ink.value.set(css("--grid"));
    this.floor.plane.material.opacity = Number(css("--shadow"));
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }

  // pixels from the left and the top of the canvas
  project(point) {
    const p = new Vector3(...point).project(this.camera);
    return [((p.x + 1) / 2) * this.canvas.clientWidth, ((1 - p.y) / 2) * this.canvas.clientHeight];
  }

  // what lies under a pixel, of some things
  under(x, y, things) {
    return this.ray(x, y).intersectObjects(things, true)[0];
  }

  // from the eye through a pixel
  ray(x, y) {
    const ray = new Raycaster(), box = this.canvas.getBoundingClientRect();
    ray.setFromCamera(new Vector2((2 * (x - box.left)) / box.width - 1, 1 - (2 * (y - box.top)) / box.height), this.camera);
    return ray;
  }
}
