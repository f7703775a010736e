// A viewer for the tests: three's own loader and mixer, told what to show by the test.

import { AmbientLight, AnimationMixer, Box3, Color, DirectionalLight, LoopOnce, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

const scene = new Scene(), camera = new PerspectiveCamera(40, 4 / 3, 0.01, 1000);
const renderer = new WebGLRenderer({ antialias: true });
scene.background = new Color("#f4f5f7");
scene.add(new AmbientLight("#ffffff", 1.2));
const sun = new DirectionalLight("#ffffff", 2.5);
sun.position.set(2, 5, 3);
scene.add(sun);
document.body.append(renderer.domElement);
renderer.setSize(800, 600);
let mixer, root;

window.show = async (text) => {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const gltf = await new GLTFLoader().parseAsync(bytes.buffer, "");
  root = gltf.scene;
  scene.add(root);
  mixer = new AnimationMixer(root);
  for (const clip of gltf.animations) {
    const action = mixer.clipAction(clip).setLoop(LoopOnce);
    action.clampWhenFinished = true;
    action.play();
  }
  window.seek(0);
  const box = new Box3().setFromObject(root, true), size = box.getSize(new Vector3()).length(), middle = box.getCenter(new Vector3());
  camera.position.copy(middle).add(new Vector3(0.35, 0.25, 1).setLength(1.5 * size));
  camera.lookAt(middle);
  window.seek(0);
  return { duration: Math.max(0, ...gltf.animations.map((c) => c.duration)), extras: gltf.scene.userData };
};

window.seek = (t) => {
  mixer.setTime(t);
  scene.updateMatrixWorld(true);
  renderer.render(scene, camera);
};

function found(name) {
  let one;
  root.traverse((o) => { if (!one && (o.userData.name ?? o.name) === name) one = o; });
  if (!one) throw new Error(`no node ${name}`);
  return one;
}

window.at = (name) => found(name).getWorldPosition(new Vector3()).toArray();

// all vertices of what a node shows, where they are drawn
window.vertices = (name) => {
  const rows = [];
  found(name).traverse((o) => {
    if (!o.isMesh) return;
    for (let i = 0; i < o.geometry.attributes.position.count; i++) {
      const p = o.getVertexPosition(i, new Vector3());
      rows.push(p.applyMatrix4(o.matrixWorld).toArray());
    }
  });
  return rows;
};
