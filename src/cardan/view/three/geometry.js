// Solids, meshes, beams, springs and arrows as things of three.

import {
  BackSide, BoxGeometry, BufferAttribute, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DoubleSide, Group, Matrix4, Mesh,
  MeshStandardMaterial, Quaternion, SphereGeometry, Vector3,
} from "three";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";

// colors that people with any kind of sight tell apart (P. Tol, bright)
export const palette = ["#4d8fd6", "#e34d61", "#2f9e55", "#d9b93b", "#66ccee", "#b5489a", "#a07d4a", "#8080c8"];
const Y = new Vector3(0, 1, 0);
const materials = new Map();

export function material(color, more = {}) {
  const key = `${color}${JSON.stringify(more)}`;
  if (!materials.has(key)) {
    // black shows no shape: the darkest is a dark gray
    const rgb = typeof color === "string" ? new Color(color) : new Color().setRGB(...color.slice(0, 3).map((x) => x + 0.29 * (1 - x) ** 3), "srgb");
    const alpha = typeof color === "string" || color.length < 4 ? 1 : color[3];
    materials.set(key, new MeshStandardMaterial({ color: rgb, roughness: 0.42, metalness: 0.05, opacity: alpha, transparent: alpha < 1, ...more }));
  }
  return materials.get(key);
}

export function shaded(geometry, paint) {
  const mesh = new Mesh(geometry, paint);
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

// a group from a to b: y along it, scaled by whoever draws in it
function between(a, b, fill) {
  const group = new Group(), along = new Vector3().subVectors(b, a), length = along.length();
  group.position.copy(a);
  if (length > 0) group.quaternion.setFromUnitVectors(Y, along.divideScalar(length));
  fill(group, length);
  return group;
}

function cylinder(paint, length, from, to, open = false) {
  const mesh = shaded(new CylinderGeometry(to, from, length, 40, 1, open), paint);
  mesh.position.y = length / 2;
  return mesh;
}

function ball(paint, radius, at) {
  const mesh = shaded(new SphereGeometry(radius, 36, 24), paint);
  mesh.position.y = at;
  return mesh;
}

const makers = {
  sphere: (s, paint) => {
    const mesh = shaded(new SphereGeometry(s.r, 48, 32), paint);
    mesh.position.fromArray(s.a);
    return mesh;
  },
  box: (s, paint) => {
    const mesh = shaded(new BoxGeometry(...s.size), paint), R = s.R;
    mesh.applyMatrix4(new Matrix4().set(R[0], R[1], R[2], s.a[0], R[3], R[4], R[5], s.a[1], R[6], R[7], R[8], s.a[2], 0, 0, 0, 1));
    return mesh;
  },
  cylinder: (s, paint) => between(new Vector3(...s.a), new Vector3(...s.b), (g, length) => g.add(cylinder(paint, length, s.r, s.r))),
  // a rod, thinner toward its end, with balls where it may turn
  link: (s, paint) => between(new Vector3(...s.a), new Vector3(...s.b), (g, length) => {
    const end = s.end ?? s.r;
    if (length > 0) g.add(cylinder(paint, length, s.r, end, true));
    g.add(ball(paint, s.joint ? 1.3 * s.r : s.r, 0), ball(paint, end, length));
  }),
  mesh: (s, paint) => {
    const geometry = new BufferGeometry(), positions = new Float32Array(s.positions.length);
    // toCreasedNormals takes what is nearer than a hundredth for one vertex
    const most = 1e4 / (65535 * Math.max(...s.unit.map(Math.abs)) || 1);
    for (let i = 0; i < positions.length; i++) positions[i] = most * (s.low[i % 3] + s.unit[i % 3] * s.positions[i]);
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setIndex(new BufferAttribute(Uint32Array.from(s.triangles), 1));
    const mesh = shaded(toCreasedNormals(geometry, 0.6).scale(1 / most, 1 / most, 1 / most), paint), R = s.R, a = s.a;
    mesh.applyMatrix4(new Matrix4().set(R[0], R[1], R[2], a[0], R[3], R[4], R[5], a[1], R[6], R[7], R[8], a[2], 0, 0, 0, 1));
    // both sides: scales may mirror
    return mesh;
  },
};

// bodies that meet do not flicker: each lies a little behind the one before
export function solid(s, color, layer = 0) {
  const behind = { polygonOffset: true, polygonOffsetFactor: layer % 8, polygonOffsetUnits: layer % 8 };
  const paint = material(s.color || color, s.kind === "mesh" ? { side: DoubleSide, shadowSide: BackSide } : behind);
  return makers[s.kind](s, paint);
}

// arrows, drawn over everything where they stand inside of bodies

const shaft = new CylinderGeometry(1, 1, 1, 14).translate(0, 0.5, 0);
const tip = new ConeGeometry(1, 1, 22).translate(0, 0.5, 0);

export function arrow(color, over = false) {
  const group = new Group(), paint = material(color, over ? { depthTest: false, transparent: true } : {});
  const body = new Mesh(shaft, paint), head = new Mesh(tip, paint);
  body.renderOrder = head.renderOrder = over ? 9 : 0;
  group.add(body, head);
  group.point = (from, direction, length, radius) => {
    group.visible = length > 2 * radius;
    if (!group.visible) return;
    const top = Math.min(6 * radius, 0.5 * length);
    group.position.copy(from);
    group.quaternion.setFromUnitVectors(Y, direction);
    body.scale.set(radius, length - top, radius);
    head.scale.set(2.6 * radius, top, 2.6 * radius);
    head.position.y = length - top;
  };
  return group;
}

export function triad(length, radius) {
  const group = new Group();
  ["#d0434f", "#2f9e55", "#2f6fde"].forEach((color, k) => {
    const axis = arrow(color);
    axis.point(new Vector3(), new Vector3().setComponent(k, 1), length, radius);
    group.add(axis);
  });
  return group;
}

// springs and dampers between two points

// a wire around the y axis, whose thickness stays when it is stretched
function coil(paint, radius) {
  const TURNS = 9, POINTS = 25 * TURNS, AROUND = 7, wire = 0.16 * radius;
  const positions = new Float32Array(3 * (POINTS + 1) * AROUND), index = [];
  for (let i = 0; i < POINTS; i++)
    for (let k = 0; k < AROUND; k++) {
      const [a, b] = [i * AROUND + k, i * AROUND + ((k + 1) % AROUND)];
      index.push(a, b, a + AROUND, b, b + AROUND, a + AROUND);
    }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setIndex(index);
  const mesh = shaded(geometry, paint), center = new Vector3(), next = new Vector3(), along = new Vector3(), out = new Vector3(), side = new Vector3();
  mesh.frustumCulled = false;
  // straight ends of a twelfth each
  const at = (t, length, into) => {
    const wound = Math.min(1, Math.max(0, (t - 0.06) / 0.88)), wide = radius * Math.min(1, 16 * Math.min(t, 1 - t)), angle = 2 * Math.PI * TURNS * wound;
    const end = t < 0.06 ? t / 0.72 : t > 0.94 ? 1 - (1 - t) / 0.72 : 1 / 12 + (10 / 12) * wound;
    return into.set(wide * Math.cos(angle), end * length, wide * Math.sin(angle));
  };
  mesh.stretch = (length) => {
    for (let i = 0; i <= POINTS; i++) {
      at(i / POINTS, length, center);
      at((i + 0.5) / POINTS, length, next);
      along.subVectors(next, center).normalize();
      out.set(center.x, 0, center.z);
      if (out.lengthSq() < 1e-18) out.set(1, 0, 0);
      out.addScaledVector(along, -out.dot(along)).normalize();
      side.crossVectors(along, out);
      for (let k = 0; k < AROUND; k++) {
        const turn = (2 * Math.PI * k) / AROUND;
        next.copy(center).addScaledVector(out, wire * Math.cos(turn)).addScaledVector(side, wire * Math.sin(turn)).toArray(positions, 3 * (i * AROUND + k));
      }
    }
    geometry.attributes.position.needsUpdate = true;
    geometry.computeVertexNormals();
  };
  return mesh;
}

export function spring(s, radius) {
  const group = new Group(), paint = material("#7c8594"), rods = new Group();
  const wound = s.coil ? coil(paint, radius) : null;
  if (wound) group.add(wound);
  if (s.damper) {
    const thick = radius * (s.coil ? 0.45 : 0.8);
    const pot = shaded(new CylinderGeometry(thick, thick, 0.42, 24).translate(0, 0.36, 0), material("#9aa3b1"));
    rods.add(pot, shaded(new CylinderGeometry(0.16 * radius, 0.16 * radius, 1, 12).translate(0, 0.5, 0), paint));
    group.add(rods);
  }
  const along = new Vector3();
  group.stretch = (a, b) => {
    const length = along.subVectors(b, a).length();
    group.visible = length > 0;
    if (!group.visible) return;
    group.position.copy(a);
    group.quaternion.setFromUnitVectors(Y, along.divideScalar(length));
    rods.scale.set(1, length, 1);
    if (wound) wound.stretch(length);
  };
  return group;
}

// vertices of a geometry that lie farthest out in some directions: they bound it more closely than a box

const outward = [];
for (const x of [-1, 0, 1]) for (const y of [-1, 0, 1]) for (const z of [-1, 0, 1]) if (x || y || z) outward.push([x, y, z]);
export function outermost(geometry) {
  const { array, count } = geometry.attributes.position, most = outward.map(() => -Infinity), found = outward.map(() => 0);
  for (let i = 0; i < count; i++) {
    const [x, y, z] = [array[3 * i], array[3 * i + 1], array[3 * i + 2]];
    outward.forEach((d, k) => {
      const reach = d[0] * x + d[1] * y + d[2] * z;
      if (reach > most[k]) { most[k] = reach; found[k] = i; }
    });
  }
  return count ? [...new Set(found)].map((i) => new Vector3().fromArray(array, 3 * i)) : [];
}

// stress or strain: viridis, which brightens evenly and keeps its order without colors

const viridis = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129], [92, 200, 99], [170, 220, 50], [253, 231, 37]];
export function shade(x, into) {
  const k = Math.min(1, Math.max(0, x)) * (viridis.length - 1), i = Math.min(viridis.length - 2, Math.floor(k));
  const mix = (c) => (viridis[i][c] + (k - i) * (viridis[i + 1][c] - viridis[i][c])) / 255;
  return into.setRGB(mix(0), mix(1), mix(2), "srgb");
}

// a beam: its outline swept along its sections; every picture fills the arrays again. Between the
// sections runs a cubic that leaves each of them at a right angle

export function beam(b, color) {
  const pieces = Math.max(1, Math.min(8, Math.round(48 / Math.max(1, b.count - 1))));
  const n = (b.count - 1) * pieces + 1, m = b.outline.length, round = b.round, corners = round ? m : 2 * m;
  // points (y, z) of the outline with their normals; a corner stands twice
  const ring = [];
  for (let k = 0; k < m; k++) {
    const [p, q] = [b.outline[k], b.outline[(k + 1) % m]];
    if (round) ring.push([...p, p[0] / Math.hypot(...p), p[1] / Math.hypot(...p)]);
    else {
      const normal = [q[1] - p[1], p[0] - q[0]], size = Math.hypot(...normal) || 1;
      for (const point of [p, q]) ring.push([...point, normal[0] / size, normal[1] / size]);
    }
  }
  const index = [], at = (i, k) => i * corners + (k % corners);
  for (let i = 0; i < n - 1; i++)
    for (let k = 0; k < corners; k += round ? 1 : 2) index.push(at(i, k), at(i, k + 1), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k));
  const total = (n + 2) * corners, positions = new Float32Array(3 * total), normals = new Float32Array(3 * total);
  const colors = new Float32Array(3 * total);
  // flat ends, a fan each
  for (const [end, flip] of [[n, false], [n + 1, true]])
    for (let k = 1; k < corners - 1; k++) index.push(at(end, 0), at(end, flip ? k : k + 1), at(end, flip ? k + 1 : k));
  const geometry = new BufferGeometry();
  for (const [name, array] of [["position", positions], ["normal", normals], ["color", colors]])
    geometry.setAttribute(name, new BufferAttribute(array, 3));
  geometry.setIndex(index);
  const plain = new Color(color), tone = new Color();
  const mesh = shaded(geometry, new MeshStandardMaterial({ vertexColors: true, roughness: 0.5, side: DoubleSide }));
  mesh.frustumCulled = false;
  const p = new Vector3(), v = new Vector3(), turn = new Quaternion();
  const given = Array.from({ length: b.count }, () => ({ at: new Vector3(), turn: new Quaternion(), along: new Vector3(), amount: null }));
  const between = (i) => {
    // fills in p and turn at ring i; returns its amount
    const k = Math.min(b.count - 2, Math.floor(i / pieces)), x = i / pieces - k, c = given[k], d = given[k + 1];
    const length = v.subVectors(d.at, c.at).length();
    p.copy(c.at).addScaledVector(v, x * x * (3 - 2 * x));
    p.addScaledVector(c.along, length * x * (1 - x) ** 2).addScaledVector(d.along, length * x * x * (x - 1));
    turn.slerpQuaternions(c.turn, d.turn, x);
    return c.amount === null ? null : c.amount * (1 - x) + d.amount * x;
  };
  mesh.bend = (section, value) => {
    // section(i, at, turn) fills in a place; value(i) from 0 to 1, or null
    given.forEach((one, i) => {
      section(i, one.at, one.turn);
      one.along.set(1, 0, 0).applyQuaternion(one.turn);
      one.amount = value(i);
    });
    for (let i = 0; i < n + 2; i++) {
      const amount = between(i < n ? i : i === n ? 0 : n - 1);
      if (amount === null) tone.copy(plain);
      else shade(amount, tone);
      for (let k = 0; k < corners; k++) {
        const o = 3 * (i * corners + k), [y, z, ny, nz] = ring[k];
        v.set(0, y, z).applyQuaternion(turn).add(p).toArray(positions, o);
        (i < n ? v.set(0, ny, nz) : v.set(i === n ? -1 : 1, 0, 0)).applyQuaternion(turn).toArray(normals, o);
        tone.toArray(colors, o);
      }
    }
    for (const name of ["position", "normal", "color"]) geometry.attributes[name].needsUpdate = true;
  };
  return mesh;
}
