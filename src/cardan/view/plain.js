"use strict";
// A motion played on a canvas: solids are projected, sorted from far to near, shaded and filled.
const data = JSON.parse(document.getElementById("data").textContent);
const stage = document.getElementById("stage"), pen = stage.getContext("2d");
const slider = document.getElementById("time"), clock = document.getElementById("clock");
const playButton = document.getElementById("play"), tag = document.getElementById("name");
const tubes = data.beams || [];
const first = data.t[0], last = data.t[data.t.length - 1];
const palette = ["#2f6fde", "#e07b39", "#3a9d6e", "#b5508f", "#c9a227", "#5b6ee1", "#d0534f", "#3f9bb0"];

// vectors

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const mul = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => mul(a, 1 / (Math.hypot(...a) || 1));
const turn = (p, v) => [
  p[0] * v[0] + p[1] * v[1] + p[2] * v[2],
  p[3] * v[0] + p[4] * v[1] + p[5] * v[2],
  p[6] * v[0] + p[7] * v[1] + p[8] * v[2]];
const place = (p, v) => add(turn(p, v), [p[9], p[10], p[11]]);
const here = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];

// the box that all bodies stay in; where one flies off, that of the first picture

function bounds(every) {
  const low = [0, 0, 0], high = [0, 0, 0];
  const include = (p, s) => {
    const r = s.size ? Math.hypot(...s.size) / 2 : s.r || 0;
    for (const v of s.b ? [place(p, s.a), place(p, s.b)] : [place(p, s.a)])
      for (let k = 0; k < 3; k++) { low[k] = Math.min(low[k], v[k] - r); high[k] = Math.max(high[k], v[k] + r); }
  };
  for (const body of data.bodies) {
    const step = every ? Math.max(1, Math.floor(body.pose.length / 200)) : body.pose.length;
    for (let i = 0; i < body.pose.length; i += step)
      for (const s of body.solids) include(body.pose[i], s);
  }
  for (const s of data.ground) include(here, s);
  for (const beam of tubes) {
    const step = every ? Math.max(1, Math.floor(beam.path.length / 200)) : beam.path.length;
    for (let i = 0; i < beam.path.length; i += step)
      for (let k = 0; k < beam.path[i].length; k += 3)
        include(here, { a: beam.path[i].slice(k, k + 3), r: beam.r });
  }
  return { low, high, size: Math.max(...sub(high, low), 1e-6) };
}
const start = bounds(false), whole = data.live ? data.live.reach : bounds(true);
const { low, high, size } = data.live || whole.size < 3 * start.size ? whole : start;

// the camera: a target, two angles and a distance

const eye = { target: mul(add(low, high), 0.5), azimuth: -0.9, elevation: 0.35, distance: 1.6 * size };
let view;
function look() {
  const ce = Math.cos(eye.elevation), se = Math.sin(eye.elevation);
  const forward = [-ce * Math.cos(eye.azimuth), -ce * Math.sin(eye.azimuth), -se];
  const right = unit(cross(forward, [0, 0, 1]));
  view = { forward, right, up: cross(right, forward), from: sub(eye.target, mul(forward, eye.distance)),
    scale: 0.9 * Math.min(stage.width, stage.height), cx: stage.width / 2, cy: stage.height / 2 };
}
function project(v) {
  const d = sub(v, view.from), depth = Math.max(dot(d, view.forward), 1e-3 * size);
  const k = view.scale / depth;
  return [view.cx + k * dot(d, view.right), view.cy - k * dot(d, view.up), depth, k];
}

// colors

const light = unit([0.4, -0.5, 0.9]);
function rgb(hex) { return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)); }
function tone(color, k) {
  const c = color.map((x) => Math.round(Math.min(255, Math.max(0, x * k))));
  return `rgb(${c[0]},${c[1]},${c[2]})`;
}
function paint(solid, index) {
  return solid.color ? solid.color.slice(0, 3).map((x) => 255 * x) : rgb(palette[index % palette.length]);
}
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name);

// solids become things with a depth and a way to draw them

function ball(list, center, r, color) {
  const [x, y, depth, k] = project(center), R = Math.max(r * k, 1);
  list.push({ depth, draw() {
    const g = pen.createRadialGradient(x - R * 0.35, y - R * 0.4, R * 0.1, x, y, R);
    g.addColorStop(0, tone(color, 1.45)); g.addColorStop(1, tone(color, 0.72));
    pen.fillStyle = g; pen.beginPath(); pen.arc(x, y, R, 0, 7); pen.fill();
  } });
}
function rod(list, a, b, ra, rb, color) {
  // a long rod is sorted piece by piece
  const pieces = Math.min(12, Math.max(1, Math.round(Math.hypot(...sub(b, a)) / (6 * ra))));
  for (let i = 0; i < pieces; i++) {
    const s = i / pieces, e = (i + 1) / pieces;
    const p = project(add(a, mul(sub(b, a), s))), q = project(add(a, mul(sub(b, a), e)));
    const rp = Math.max((ra + (rb - ra) * s) * p[3], 1), rq = Math.max((ra + (rb - ra) * e) * q[3], 1);
    list.push({ depth: (p[2] + q[2]) / 2, draw() { capsule(p, q, rp, rq, color); } });
  }
}
function capsule(p, q, rp, rq, color) {
  const dx = q[0] - p[0], dy = q[1] - p[1], angle = Math.atan2(dy, dx);
  let nx = -Math.sin(angle), ny = Math.cos(angle);
  if (ny > 0 || (ny === 0 && nx > 0)) { nx = -nx; ny = -ny; }
  const R = Math.max(rp, rq), g = pen.createLinearGradient(p[0] + nx * R, p[1] + ny * R, p[0] - nx * R, p[1] - ny * R);
  g.addColorStop(0, tone(color, 0.95)); g.addColorStop(0.3, tone(color, 1.35)); g.addColorStop(1, tone(color, 0.62));
  pen.fillStyle = g; pen.beginPath();
  pen.arc(p[0], p[1], rp, angle + Math.PI / 2, angle - Math.PI / 2);
  pen.arc(q[0], q[1], rq, angle - Math.PI / 2, angle + Math.PI / 2);
  pen.closePath(); pen.fill();
}
function face(list, corners, color) {
  const normal = unit(cross(sub(corners[1], corners[0]), sub(corners[2], corners[0])));
  const middle = mul(corners.reduce(add), 1 / corners.length);
  if (dot(normal, sub(middle, view.from)) > 0) return;
  const points = corners.map(project), shade = 0.75 + 0.45 * dot(normal, light);
  list.push({ depth: project(middle)[2], draw() {
    pen.fillStyle = pen.strokeStyle = tone(color, shade); pen.lineWidth = 1; pen.beginPath();
    points.forEach((c, i) => (i ? pen.lineTo(c[0], c[1]) : pen.moveTo(c[0], c[1])));
    pen.closePath(); pen.fill(); pen.stroke();
  } });
}
function box(list, pose, solid, color) {
  const at = (x, y, z) => {
    const half = [x * solid.size[0] / 2, y * solid.size[1] / 2, z * solid.size[2] / 2];
    return place(pose, add(solid.a, turn(solid.R, half)));
  };
  for (const s of [-1, 1]) {
    const faces = [
      [at(s, -1, -1), at(s, 1, -1), at(s, 1, 1), at(s, -1, 1)],
      [at(-1, s, -1), at(-1, s, 1), at(1, s, 1), at(1, s, -1)],
      [at(-1, -1, s), at(1, -1, s), at(1, 1, s), at(-1, 1, s)]];
    for (const corners of faces) face(list, s > 0 ? corners : corners.reverse(), color);
  }
}
function cylinder(list, a, b, r, color) {
  const n = 20, axis = unit(sub(b, a));
  const side = unit(cross(axis, Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0])), other = cross(axis, side);
  const rim = (end, i) => add(end, add(mul(side, r * Math.cos(2 * Math.PI * i / n)), mul(other, r * Math.sin(2 * Math.PI * i / n))));
  const top = [], bottom = [];
  for (let i = 0; i < n; i++) {
    face(list, [rim(a, i), rim(a, i + 1), rim(b, i + 1), rim(b, i)], color);
    top.push(rim(b, i)); bottom.unshift(rim(a, i));
  }
  face(list, top, color); face(list, bottom, color);
}
function solidOf(list, pose, solid, color) {
  if (solid.kind === "box") return box(list, pose, solid, color);
  const a = place(pose, solid.a);
  if (solid.kind === "sphere") return ball(list, a, solid.r, color);
  const b = place(pose, solid.b);
  if (solid.kind === "cylinder") return cylinder(list, a, b, solid.r, color);
  const end = solid.end === undefined ? solid.r : solid.end;
  rod(list, a, b, solid.r, end, color);
  if (solid.joint) ball(list, a, 1.3 * solid.r, color);
}

function pointsOf(beam, a, b, k) {
  // the nodes of a beam, straight between two rows
  const p = beam.path[a], q = beam.path[b], points = [];
  for (let i = 0; i < p.length; i += 3)
    points.push([0, 1, 2].map((j) => p[i + j] + k * (q[i + j] - p[i + j])));
  return points;
}
function tube(list, points, r, color) {
  for (let i = 1; i < points.length; i++) rod(list, points[i - 1], points[i], r, r, color);
}

// the floor and the axes

function floor() {
  const rough = size / 4, power = 10 ** Math.floor(Math.log10(rough));
  const cell = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= rough);
  const z = low[2] - 0.04 * size, n = 6;
  const cx = Math.round(eye.target[0] / cell) * cell, cy = Math.round(eye.target[1] / cell) * cell;
  pen.strokeStyle = css("--faint"); pen.lineWidth = devicePixelRatio;
  for (let i = -n; i <= n; i++)
    for (const [from, to] of [[[cx + i * cell, cy - n * cell, z], [cx + i * cell, cy + n * cell, z]],
                              [[cx - n * cell, cy + i * cell, z], [cx + n * cell, cy + i * cell, z]]])
      segment(from, to);
}
function shadow(pose, solid) {
  // the light from above: ends dropped to the floor, a soft stroke between them
  const z = low[2] - 0.04 * size, drop = (v) => [v[0], v[1], z];
  let ends = [place(pose, solid.a)], wide = solid.r;
  if (solid.b) ends.push(place(pose, solid.b));
  if (solid.kind === "box") {
    const k = solid.size.indexOf(Math.max(...solid.size)), half = [0, 0, 0];
    half[k] = solid.size[k] / 2;
    ends = [1, -1].map((s) => place(pose, add(solid.a, mul(turn(solid.R, half), s))));
    wide = solid.size.reduce((a, b) => a + b) / 2 - solid.size[k] / 2;
    wide /= 2;
  }
  const near = 0.02 * size, from = drop(ends[0]), to = drop(ends[ends.length - 1]);
  if ([from, to].some((v) => dot(sub(v, view.from), view.forward) < near)) return;
  const p = project(from), q = project(to);
  pen.lineWidth = Math.max(1, wide * (p[3] + q[3]));
  pen.beginPath(); pen.moveTo(p[0], p[1]); pen.lineTo(q[0] + 0.01, q[1]); pen.stroke();
}
function segment(from, to) {
  // cut what lies behind the eye
  const near = 0.02 * size, d = (v) => dot(sub(v, view.from), view.forward) - near;
  let a = from, b = to;
  const da = d(a), db = d(b);
  if (da < 0 && db < 0) return;
  if (da < 0) a = add(a, mul(sub(b, a), da / (da - db)));
  if (db < 0) b = add(b, mul(sub(a, b), db / (db - da)));
  const p = project(a), q = project(b);
  pen.beginPath(); pen.moveTo(p[0], p[1]); pen.lineTo(q[0], q[1]); pen.stroke();
}
function triad() {
  const ratio = devicePixelRatio, x = stage.width - 60 * ratio, y = 60 * ratio, length = 34 * ratio;
  [["x", "#d0534f", [1, 0, 0]], ["y", "#3a9d6e", [0, 1, 0]], ["z", "#2f6fde", [0, 0, 1]]].forEach(([letter, color, v]) => {
    const px = x + length * dot(v, view.right), py = y - length * dot(v, view.up);
    pen.strokeStyle = pen.fillStyle = color; pen.lineWidth = 2 * ratio;
    pen.beginPath(); pen.moveTo(x, y); pen.lineTo(px, py); pen.stroke();
    pen.font = `${12 * ratio}px system-ui, sans-serif`; pen.fillText(letter, px + 4 * ratio, py);
  });
}

// time

let t = first, playing = true, before = null, pointer = null, grip = null, poses = [], lines = [];
function row() {
  let a = 0, b = data.t.length - 1;
  const forward = last >= first;
  while (b - a > 1) { const m = (a + b) >> 1; if (forward ? data.t[m] <= t : data.t[m] >= t) a = m; else b = m; }
  return [a, b, Math.min(1, Math.max(0, (t - data.t[a]) / ((data.t[b] - data.t[a]) || 1)))];
}
function between(p, q, k) {
  // straight between two rows, then axes of unit length at right angles again
  const m = p.map((x, i) => x + k * (q[i] - x));
  const x = unit([m[0], m[3], m[6]]);
  const y0 = [m[1], m[4], m[7]], y = unit(sub(y0, mul(x, dot(x, y0)))), z = cross(x, y);
  return [x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2], m[9], m[10], m[11]];
}
function frame(now) {
  if (playing && before !== null) {
    t += (now - before) / 1000 * Number(document.getElementById("rate").value) * Math.sign(last - first || 1);
    if ((t - last) * (last - first) > 0) t = first;
    slider.value = (t - first) / ((last - first) || 1);
  }
  before = now;
  draw();
  requestAnimationFrame(frame);
}
function draw() {
  const ratio = devicePixelRatio || 1;
  if (stage.width !== innerWidth * ratio || stage.height !== innerHeight * ratio) {
    stage.width = innerWidth * ratio; stage.height = innerHeight * ratio;
  }
  look();
  pen.clearRect(0, 0, stage.width, stage.height);
  floor();
  const list = [], [a, b, k] = row();
  poses = live ? live.poses : data.bodies.map((body) => between(body.pose[a], body.pose[b], k));
  pen.strokeStyle = css("--shade"); pen.lineCap = "round";
  data.bodies.forEach((body, k) => body.solids.forEach((s) => shadow(poses[k], s)));
  lines = tubes.map((beam) => pointsOf(beam, a, b, k));
  tubes.forEach((beam, i) => lines[i].slice(1).forEach((v, j) =>
    shadow(here, { kind: "tube", a: lines[i][j], b: v, r: beam.r })));
  pen.lineCap = "butt";
  for (const s of data.ground) solidOf(list, here, s, s.color ? paint(s, 0) : [128, 134, 145]);
  data.bodies.forEach((body, k) => body.solids.forEach((s) => solidOf(list, poses[k], s, paint(s, k))));
  tubes.forEach((beam, i) => tube(list, lines[i], beam.r, rgb(palette[(data.bodies.length + i) % palette.length])));
  list.sort((p, q) => q.depth - p.depth).forEach((thing) => thing.draw());
  if (live) {
    live.trails.forEach((points, k) => path(points, palette[(k + 1) % palette.length]));
    if (live.line) path(live.line, css("--ink"));
  }
  triad();
  clock.textContent = `${t.toFixed(2)} / ${last.toFixed(2)} s`;
  name();
}
function path(points, color) {
  pen.strokeStyle = color; pen.lineWidth = 1.5 * devicePixelRatio;
  for (let i = 1; i < points.length; i++) segment(points[i - 1], points[i]);
}
function away(p, q) {
  // pixels from the pointer to the segment from p to q
  const dx = q[0] - p[0], dy = q[1] - p[1], length = dx * dx + dy * dy || 1;
  const k = Math.min(1, Math.max(0, ((pointer[0] - p[0]) * dx + (pointer[1] - p[1]) * dy) / length));
  return Math.hypot(p[0] + k * dx - pointer[0], p[1] + k * dy - pointer[1]);
}
function under() {
  // the body whose solid is nearest under the pointer
  let best = null, nearest = 4 * devicePixelRatio;
  data.bodies.forEach((body, k) => body.solids.forEach((s) => {
    const p = project(place(poses[k], s.a)), q = s.b ? project(place(poses[k], s.b)) : p;
    const d = away(p, q) - (s.r || Math.min(...s.size) / 2) * p[3];
    if (d < nearest) { nearest = d; best = { k, body, depth: (p[2] + q[2]) / 2, c: [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2] }; }
  }));
  return { best, nearest };
}
function name() {
  let { best, nearest } = pointer && !grip ? under() : { best: null, nearest: 0 };
  if (pointer && !grip) tubes.forEach((beam, i) => lines[i].slice(1).forEach((v, j) => {
    const p = project(lines[i][j]), q = project(v), d = away(p, q) - beam.r * p[3];
    if (d < nearest) { nearest = d; best = { body: beam, c: [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2] }; }
  }));
  tag.style.display = best ? "block" : "none";
  if (best) {
    tag.textContent = best.body.name;
    tag.style.left = best.c[0] / devicePixelRatio + 14 + "px";
    tag.style.top = best.c[1] / devicePixelRatio - 26 + "px";
  }
}

// hands

function toggle() { playing = !playing; playButton.textContent = playing ? "\u25ae\u25ae" : "\u25b6"; }
playButton.onclick = toggle;
slider.oninput = () => { t = first + Number(slider.value) * (last - first); if (playing) toggle(); };
addEventListener("keydown", (e) => { if (e.code === "Space" && e.target !== playButton) { e.preventDefault(); toggle(); } });
stage.onpointerdown = (e) => { grip = [e.clientX, e.clientY]; stage.setPointerCapture(e.pointerId); };
stage.onpointerup = () => { grip = null; };
stage.onpointerleave = () => { pointer = null; };
stage.onpointermove = (e) => {
  pointer = [e.clientX * devicePixelRatio, e.clientY * devicePixelRatio];
  if (!grip) return;
  const dx = e.clientX - grip[0], dy = e.clientY - grip[1];
  grip = [e.clientX, e.clientY];
  if (e.shiftKey) {
    const k = eye.distance / view.scale * devicePixelRatio;
    eye.target = add(eye.target, add(mul(view.right, -dx * k), mul(view.up, dy * k)));
  } else {
    eye.azimuth -= dx * 0.008;
    eye.elevation = Math.min(1.55, Math.max(-1.55, eye.elevation + dy * 0.008));
  }
};
stage.addEventListener("wheel", (e) => { e.preventDefault(); eye.distance *= Math.exp(e.deltaY * 0.001); }, { passive: false });
// a model that runs in the page: live_panel.js

let live = null;
function unproject(x, y, depth) {
  const k = view.scale / depth, [px, py] = [x * devicePixelRatio, y * devicePixelRatio];
  return add(view.from, add(mul(view.forward, depth), add(mul(view.right, (px - view.cx) / k), mul(view.up, (view.cy - py) / k))));
}
const viewer = {
  place(frames) { live.poses = data.bodies.map((_, k) => [...frames.subarray(18 * k, 18 * k + 12)]); },
  trail(k, points) { live.trails[k] = points; },
  line(ends) { live.line = ends; },
  hold() { grip = null; },
  // turned, moved, zoomed or pointed at
  changed: () => true,
  solids: (k) => (k < 0 ? data.ground : data.bodies[k].solids),
  reshaped() {},
  pick(x, y) {
    pointer = [x * devicePixelRatio, y * devicePixelRatio];
    const { best } = under();
    return best && { body: best.k, point: unproject(x, y, best.depth) };
  },
  across(x, y, point) { return unproject(x, y, project(point)[2]); },
  draw,
};
if (data.live) {
  live = { poses: data.bodies.map((body) => body.pose[0]), trails: [], line: null };
  document.querySelector("footer").hidden = true;
  look();
  draw();
  startLive(data, viewer);
} else requestAnimationFrame(frame);
