// Surfaces that deform: points move by shapes times amplitudes, triangles or lines between them follow.

import {
  BufferAttribute, BufferGeometry, Color, CylinderGeometry, DoubleSide, Group, IcosahedronGeometry, InstancedMesh, LineBasicMaterial,
  LineSegments, Matrix4, MeshStandardMaterial, Quaternion, Sphere, Vector3,
} from "three";
import { shade, shaded } from "./geometry.js";

const Y = new Vector3(0, 1, 0), BARE = new Color("#b9bec8"), MOST_BALLS = 5000;

function box(points) {
  const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate(), p = new Vector3();
  for (let i = 0; i < points.length; i += 3) { p.fromArray(points, i); low.min(p); high.max(p); }
  return [low, high];
}

// the equivalent stress of von Mises; components xx, yy, zz, yz, zx, xy
const mises = (a, b, c, d, e, f) => Math.sqrt(((a - b) ** 2 + (b - c) ** 2 + (c - a) ** 2) / 2 + 3 * (d * d + e * e + f * f));

export function surface(s, color, most) {
  const { points, shapes, stresses, stressed } = s, n = points.length / 3, modes = shapes.length / points.length;
  const positions = Float32Array.from(points), moved = new Float64Array(points.length), colors = new Float32Array(points.length);
  const group = new Group(), plain = new Color(color), tone = new Color(), [low, high] = box(points);
  const size = Math.max(...new Vector3().subVectors(high, low).toArray(), 1e-9);
  const paint = { roughness: 0.5, metalness: 0.05, side: DoubleSide };
  const sphere = new Sphere(new Vector3().addVectors(low, high).multiplyScalar(0.5), 2 * size);
  const draw = [];
  if (s.triangles) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("color", new BufferAttribute(colors, 3));
    geometry.setIndex(new BufferAttribute(Uint32Array.from(s.triangles), 1));
    geometry.boundingSphere = sphere;
    // the card finds the normals of what bends
    const mesh = shaded(geometry, new MeshStandardMaterial({ ...paint, vertexColors: true, flatShading: true }));
    mesh.frustumCulled = false;
    group.add(mesh);
    draw.push(() => { for (const name of ["position", "color"]) geometry.attributes[name].needsUpdate = true; });
  } else {
    const many = (geometry, count) => {
      const mesh = new InstancedMesh(geometry, new MeshStandardMaterial(paint), count);
      mesh.castShadow = mesh.receiveShadow = true;
      mesh.frustumCulled = false;
      mesh.boundingSphere = sphere;
      group.add(mesh);
      return mesh;
    };
    // nodes alone are seen by their size
    const radius = size / (s.lines ? 300 : 120), place = new Matrix4(), turn = new Quaternion(), a = new Vector3(), b = new Vector3(), thick = new Vector3();
    const ink = (i, j) => tone.setRGB(...[0, 1, 2].map((c) => (colors[3 * i + c] + colors[3 * j + c]) / 2));
    const step = Math.ceil(n / MOST_BALLS), balls = many(new IcosahedronGeometry(1, 1), Math.ceil(n / step));
    draw.push(() => {
      for (let i = 0, k = 0; i < n; i += step, k++) {
        balls.setMatrixAt(k, place.makeScale(radius, radius, radius).setPosition(a.fromArray(positions, 3 * i)));
        balls.setColorAt(k, ink(i, i));
      }
      balls.instanceMatrix.needsUpdate = balls.instanceColor.needsUpdate = true;
    });
    const count = s.lines ? s.lines.length / 2 : 0;
    if (count) {
      const rods = many(new CylinderGeometry(1, 1, 1, 12, 1, true).translate(0, 0.5, 0), count);
      draw.push(() => {
        for (let k = 0; k < count; k++) {
          const [i, j] = [s.lines[2 * k], s.lines[2 * k + 1]];
          a.fromArray(positions, 3 * i);
          const length = b.fromArray(positions, 3 * j).sub(a).length();
          turn.setFromUnitVectors(Y, length > 0 ? b.divideScalar(length) : b.copy(Y));
          rods.setMatrixAt(k, place.compose(a, turn, thick.set(radius, length, radius)));
          rods.setColorAt(k, ink(i, j));
        }
        rods.instanceMatrix.needsUpdate = rods.instanceColor.needsUpdate = true;
      });
    }
  }
  if (s.outline) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(Float32Array.from(points), 3));
    geometry.setIndex(new BufferAttribute(Uint32Array.from(s.outline), 1));
    const still = new LineSegments(geometry, new LineBasicMaterial({ color: "#8a919d", transparent: true, opacity: 0.7 }));
    still.raycast = () => {};
    group.add(still);
  }
  const move = (i, amplitude) => {
    let x = 0;
    for (let m = 0; m < modes; m++) x += amplitude(m) * shapes[m * points.length + i];
    return x;
  };
  const known = stressed ? Int32Array.from(stressed) : null;
  const value = (k, amplitude) => mises(...[0, 1, 2, 3, 4, 5].map((c) => {
    let x = 0;
    for (let m = 0; m < modes; m++) x += amplitude(m) * stresses[(m * known.length + k) * 6 + c];
    return x;
  }));
  const colorAt = (i, amount) => (amount === null ? tone.copy(BARE) : shade(amount / most, tone)).toArray(colors, 3 * i);
  // amplitude(m) of each shape; colored: whether values are shown
  group.deform = (amplitude, colored) => {
    for (let i = 0; i < points.length; i++) { moved[i] = move(i, amplitude); positions[i] = points[i] + moved[i]; }
    if (!colored || !s.kind) for (let i = 0; i < n; i++) plain.toArray(colors, 3 * i);
    else if (s.kind === "displacement") for (let i = 0; i < n; i++) colorAt(i, Math.hypot(moved[3 * i], moved[3 * i + 1], moved[3 * i + 2]));
    else {
      for (let i = 0; i < n; i++) colorAt(i, null);
      if (known) known.forEach((i, k) => colorAt(i, value(k, amplitude)));
    }
    for (const one of draw) one();
  };
  // places of some points, for the camera
  const some = Math.max(1, Math.floor(n / 300));
  group.cloud = (amplitude, at, turn) => {
    const places = [];
    for (let i = 0; i < n; i += some) {
      const point = new Vector3(...[0, 1, 2].map((c) => points[3 * i + c] + move(3 * i + c, amplitude)));
      places.push(at ? point.applyQuaternion(turn).add(at) : point);
    }
    return places;
  };
  // place and color of a point
  group.point = (k) => [
    new Vector3().fromArray(positions, 3 * k).applyQuaternion(group.quaternion).add(group.position).toArray(), [...colors.slice(3 * k, 3 * k + 3)],
  ];
  return group;
}
