// The page: what is drawn, time, and hands.

import { BufferAttribute, BufferGeometry, Group, Line, LineBasicMaterial, Matrix4, Plane, Quaternion, Vector3 } from "three";
import { arrow, beam, outermost, palette, shade, solid, spring, triad } from "./geometry.js";
import { holders, posts } from "./supports.js";
import { short, Strip } from "./strip.js";
import { Stage } from "./stage.js";
import { surface } from "./surface.js";
import { load } from "./unpack.js";

const $ = (id) => document.getElementById(id);
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const element = (tag, more = {}, ...children) => {
  const made = Object.assign(document.createElement(tag), more);
  made.append(...children);
  return made;
};
const AXES = ["#d0434f", "#2f9e55", "#2f6fde"];
const GREY = "#8a919d";
const LAYERS = { reactions: "#e08700", forces: "#c2255c", contacts: "#c2255c" };

function box(points) {
  const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
  for (const p of points) { low.min(p); high.max(p); }
  return [low, high];
}

function size(points) {
  const [low, high] = box(points);
  return Math.max(...high.sub(low).toArray());
}

function middle(points) {
  const [low, high] = box(points);
  return low.add(high).multiplyScalar(0.5);
}

class Page {
  constructor(data) {
    this.data = data;
    this.t = data.t;
    this.nt = data.t.length;
    [this.first, this.last] = [this.t[0], this.t[this.nt - 1]];
    this.sense = Math.sign(this.last - this.first) || 1;
    Object.assign(this, { now: this.first, playing: false, rate: data.rate, following: null, dirty: true });
    this.stage = new Stage($("stage"), data, () => { this.dirty = true; });
    this.build();
    this.frame();
    this.hands();
    this.layersOn(data.layers);
    this.theme();
    new ResizeObserver(() => this.resize()).observe($("stage"));
    this.resize();
    this.stage.look();
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.hash();
    if (!still && this.nt > 1 && !this.paused) this.play(true);
    if (data.live) return;
    const loop = (stamp) => { this.tick(stamp); requestAnimationFrame(loop); };
    requestAnimationFrame(loop);
  }

  // what is drawn

  build() {
    const { data, stage } = this;
    this.bodies = data.bodies.map((body, k) => {
      const group = new Group();
      group.name = body.name;
      this.fill(group, body.solids, k);
      stage.scene.add(group);
      return group;
    });
    const ground = new Group();
    ground.name = "ground";
    // posts on the floor take the place of links between what the ground holds
    const hasPosts = stage.floor && data.supports.length;
    for (const s of hasPosts ? [] : data.ground) ground.add(solid(s, GREY));
    for (const s of data.supports) if (holders[s.kind]) ground.add(holders[s.kind](s, GREY));
    stage.scene.add(ground);
    this.ground = ground;
    this.beams = data.beams.map((b, k) => {
      const mesh = beam(b, palette[(data.bodies.length + k) % palette.length]);
      mesh.name = b.name;
      stage.scene.add(mesh);
      return mesh;
    });
    this.surfaces = data.surfaces.map((s, k) => {
      const group = surface(s, palette[(data.bodies.length + data.beams.length + k) % palette.length], data.scale?.most || 1);
      group.name = s.name;
      stage.scene.add(group);
      return group;
    });
    this.named = [...this.bodies, ...this.beams, ...this.surfaces];
    // what the camera may go with
    this.carriers = [...this.bodies, ...this.surfaces];
  }

  fill(group, solids, k) {
    for (const s of solids) group.add(solid(s, s.kind === "mesh" ? "#d5d9e0" : palette[k % palette.length], k));
  }

  // what hangs on the size of the scene, once it is known
  frame() {
    const { stage, data } = this;
    const cloud = this.inView();
    // a floor below the base of a robot, or below its feet where it stands on some
    const lowest = (points) => points.reduce((least, p) => Math.min(least, p.dot(stage.up)), Infinity);
    const [base, feet] = [lowest(this.cloud([])), lowest(this.cloud([0]))];
    const ground = feet < base - 0.2 * size(cloud) ? feet : base;
    stage.frame(cloud, { below: lowest(cloud) - 0.04 * size(cloud), ground }[data.floor] ?? data.floor);
    if (stage.floor) for (const part of data.supports.flatMap((s) => posts(s, stage, GREY))) this.ground.add(part);
    // things that go far keep arrows of their own size
    const unit = Math.min(stage.size, 2.5 * size(this.cloud([0])) || stage.size);
    this.unit = unit;
    if (stage.floor) $("cell").textContent = `grid ${short(stage.cell)} m`;
    this.triads = this.bodies.map((group) => {
      const axes = triad(0.12 * unit, 0.004 * unit);
      axes.visible = false;
      group.add(axes);
      return axes;
    });
    this.springs = data.springs.map((s) => {
      const drawn = spring(s, 0.022 * unit);
      drawn.name = s.name;
      stage.scene.add(drawn);
      return drawn;
    });
    this.arrows = data.arrows.map((a) => {
      const drawn = arrow(LAYERS[a.layer], true), sizes = [];
      for (let i = 0; i < a.vector.length; i += 3) sizes.push(Math.hypot(a.vector[i], a.vector[i + 1], a.vector[i + 2]));
      drawn.sizes = sizes;
      drawn.name = a.name;
      drawn.visible = false;
      stage.scene.add(drawn);
      return drawn;
    });
    // arrows of one layer share a scale: nine tenths of them stay below half of the picture
    this.scales = Object.fromEntries(Object.keys(LAYERS).map((layer) => {
      const all = this.arrows.flatMap((a, k) => (data.arrows[k].layer === layer ? a.sizes : [])).sort((a, b) => a - b);
      return [layer, all[Math.floor(0.9 * (all.length - 1))] || all[all.length - 1] || 1];
    }));
    this.traces = new Map();
    for (const trace of data.traces) this.traces.set(trace.name, this.trail(trace.at, 3, 0, this.traces.size));
  }

  rows(most) {
    const step = Math.max(1, Math.floor((this.nt - 1) / most)), rows = [];
    for (let i = 0; i < this.nt; i += step) rows.push(i);
    return rows;
  }

  // what the picture has to hold: everything, but for a few bodies that fly off; of what goes far, its start
  inView() {
    const { data } = this;
    if (data.live) {
      const { low, high } = data.live.reach;
      return [...this.cloud([0]), ...[0, 1, 2, 3, 4, 5, 6, 7].map((k) => new Vector3(...[0, 1, 2].map((c) => (k & (1 << c) ? high : low)[c])))];
    }
    const start = size(this.cloud([0])), rows = this.rows(60), whole = this.cloud(rows);
    if (size(whole) < 3 * start || !(start > 0)) return whole;
    const center = middle(this.cloud([0]));
    const stays = this.carriers.map((_, b) => this.cloud(rows, [b]).every((p) => p.distanceTo(center) < 2 * start));
    if (stays.filter(Boolean).length > this.carriers.length / 2) return this.cloud(rows, stays.flatMap((stay, b) => (stay ? [b] : [])));
    if (size(whole) < 12 * start) return whole;
    // the camera goes with what goes far
    if (data.follow === null) data.follow = Math.max(0, stays.indexOf(false));
    let most = rows.length;
    while (most > 1 && size(this.cloud(rows.slice(0, most))) > 3 * start) most--;
    return this.cloud(rows.slice(0, most));
  }

  // outermost points of everything, or of some bodies alone, at some rows
  cloud(rows, some = null) {
    const points = [], { data } = this, p = new Vector3(), q = new Quaternion();
    const corners = [...this.bodies, this.ground].map((group) => {
      const found = [];
      group.traverse((one) => {
        if (!one.geometry) return;
        one.updateMatrix();
        const inner = one.matrix.clone();
        for (let up = one.parent; up && up !== group; up = up.parent) { up.updateMatrix(); inner.premultiply(up.matrix); }
        for (const point of outermost(one.geometry)) found.push(point.applyMatrix4(inner));
      });
      return found.length ? found : group === this.ground ? [] : [new Vector3()];
    });
    for (const i of rows) {
      data.bodies.forEach((_, b) => {
        if (some && !some.includes(b)) return;
        const o = data.poses.columns * i + 7 * b;
        p.fromArray(data.poses, o); q.fromArray(data.poses, o + 3);
        for (const c of corners[b]) points.push(c.clone().applyQuaternion(q).add(p));
      });
      for (const b of some && some.length < 2 ? [] : data.beams) {
        const r = Math.max(...b.outline.flat().map(Math.abs));
        for (let k = 0; k < b.count; k++) {
          p.fromArray(b.places, b.places.columns * i + 7 * k);
          points.push(p.clone().addScalar(r), p.clone().addScalar(-r));
        }
      }
      this.surfaces.forEach((one, n) => {
        if (some && !some.includes(data.bodies.length + n)) return;
        const { amplitudes, places } = data.surfaces[n];
        if (places) { p.fromArray(places, 7 * i); q.fromArray(places, 7 * i + 3); }
        points.push(...one.cloud((m) => amplitudes[amplitudes.columns * i + m], places && p, q));
      });
      for (const s of some ? [] : data.springs) for (const k of [0, 3]) points.push(new Vector3().fromArray(s.ends, 6 * i + k));
    }
    if (!some || some.length > 1) points.push(...corners[corners.length - 1]);
    return points.length ? points : [new Vector3()];
  }

  // the way of a point, drawn up to now
  trail(array, columns, offset, k) {
    const positions = new Float32Array(3 * this.nt);
    for (let i = 0; i < this.nt; i++) for (let c = 0; c < 3; c++) positions[3 * i + c] = array[columns * i + offset + c];
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    const line = new Line(geometry, new LineBasicMaterial({ color: palette[(k + 1) % palette.length] }));
    line.frustumCulled = false;
    this.stage.scene.add(line);
    return line;
  }

  toggleTrace(k, on) {
    const name = this.data.bodies[k].name;
    if (on && !this.traces.has(k)) this.traces.set(k, this.trail(this.data.poses, this.data.poses.columns, 7 * k, k));
    if (this.traces.has(k)) this.traces.get(k).visible = on;
    this.dirty = true;
    return name;
  }

  // time

  row(t) {
    let [a, b] = [0, Math.max(0, this.nt - 2)];
    while (a < b) {
      const middle = (a + b + 1) >> 1;
      if ((this.t[middle] - t) * this.sense <= 0) a = middle; else b = middle - 1;
    }
    const next = Math.min(a + 1, this.nt - 1), span = this.t[next] - this.t[a];
    return [a, next, span ? Math.min(1, Math.max(0, (t - this.t[a]) / span)) : 0];
  }

  place() {
    if (this.running) return [0, 0];
    const { data } = this, [i, j, k] = this.row(this.now), columns = data.poses ? data.poses.columns : 0;
    const p = new Vector3(), q = new Quaternion(), v = new Vector3();
    const mixed = (array, width, offset, into) => into.fromArray(array, width * i + offset).lerp(v.fromArray(array, width * j + offset), k);
    const turned = (array, width, offset, into) => into.fromArray(array, width * i + offset).slerp(q.fromArray(array, width * j + offset), k);
    this.bodies.forEach((group, b) => {
      mixed(data.poses, columns, 7 * b, group.position);
      turned(data.poses, columns, 7 * b + 3, group.quaternion);
    });
    this.beams.forEach((mesh, b) => {
      const { places, values, count } = data.beams[b];
      mesh.bend(
        (n, at, turn) => { mixed(places, 7 * count, 7 * n, at); turned(places, 7 * count, 7 * n + 3, turn); },
        (n) => (values && this.stress ? (values[count * i + n] * (1 - k) + values[count * j + n] * k) / (data.scale.most || 1) : null),
      );
    });
    this.surfaces.forEach((one, n) => {
      const { amplitudes, places } = data.surfaces[n], width = amplitudes.columns;
      if (places) { mixed(places, 7, 0, one.position); turned(places, 7, 3, one.quaternion); }
      one.deform((m) => amplitudes[width * i + m] * (1 - k) + amplitudes[width * j + m] * k, this.stress);
    });
    const a = new Vector3(), b = new Vector3();
    this.springs.forEach((s, n) => s.stretch(mixed(data.springs[n].ends, 6, 0, a), mixed(data.springs[n].ends, 6, 3, b)));
    const unit = this.unit;
    this.arrows.forEach((one, n) => {
      const { at, vector, layer } = data.arrows[n];
      if (!this.layers[layer]) { one.visible = false; return; }
      const force = mixed(vector, 3, 0, b).length();
      one.point(mixed(at, 3, 0, a), force ? b.divideScalar(force) : b.set(0, 0, 1), Math.min(2, force / this.scales[layer]) * 0.3 * unit, 0.006 * unit);
    });
    for (const line of this.traces.values()) line.geometry.setDrawRange(0, i + 2);
    if (this.following) {
      this.stage.carry(p.subVectors(this.following.position, this.was));
      this.was.copy(this.following.position);
    }
    return [i, k];
  }

  // a model that runs in the page: live_panel.js
  viewer() {
    const { stage, data } = this, turn = new Matrix4(), n = data.bodies.length, plane = new Plane(), at = new Vector3();
    const trails = [], hand = new Line(new BufferGeometry().setFromPoints([at, at]), new LineBasicMaterial({ color: "#c2255c" }));
    hand.frustumCulled = hand.visible = false;
    stage.scene.add(hand);
    this.running = true;
    return {
      place: (frames) => {
        this.bodies.forEach((group, k) => {
          const f = frames.subarray(18 * k, 18 * k + 12);
          group.quaternion.setFromRotationMatrix(turn.set(f[0], f[1], f[2], 0, f[3], f[4], f[5], 0, f[6], f[7], f[8], 0, 0, 0, 0, 1));
          group.position.fromArray(f, 9);
        });
        const first = 18 * (n + data.live.traces.length) + 9, end = (k) => new Vector3().fromArray(frames, first + 18 * k);
        this.springs.forEach((s, k) => s.stretch(end(2 * k), end(2 * k + 1)));
        if (this.following) {
          stage.carry(at.subVectors(this.following.position, this.was));
          this.was.copy(this.following.position);
        }
      },
      trail: (k, points) => {
        if (!trails[k]) {
          trails[k] = new Line(new BufferGeometry(), new LineBasicMaterial({ color: palette[(k + 1) % palette.length] }));
          trails[k].frustumCulled = false;
          trails[k].geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * 600), 3));
          stage.scene.add(trails[k]);
        }
        const { position } = trails[k].geometry.attributes;
        points.forEach((p, i) => position.setXYZ(i, ...p));
        position.needsUpdate = true;
        trails[k].geometry.setDrawRange(0, points.length);
      },
      line: (ends) => {
        hand.visible = !!ends;
        if (ends) hand.geometry.setFromPoints(ends.map((p) => new Vector3(...p)));
      },
      hold: (on) => { stage.controls.enabled = !on; },
      pick: (x, y) => {
        const hit = stage.under(x, y, this.bodies.filter((group) => group.visible));
        let thing = hit && hit.object;
        while (thing && !this.bodies.includes(thing)) thing = thing.parent;
        return thing ? { body: this.bodies.indexOf(thing), point: hit.point.toArray() } : null;
      },
      across: (x, y, point) => {
        plane.setFromNormalAndCoplanarPoint(stage.camera.getWorldDirection(new Vector3()), at.fromArray(point));
        return (stage.ray(x, y).ray.intersectPlane(plane, new Vector3()) ?? at).toArray();
      },
      draw: () => { this.dirty = false; stage.draw(); this.axes(); },
      changed: () => this.dirty,
      solids: (k) => (k < 0 ? data.ground : data.bodies[k].solids),
      reshaped: (k) => {
        const group = k < 0 ? this.ground : this.bodies[k];
        for (const one of [...group.children]) if (k < 0 || one !== this.triads[k]) { one.removeFromParent(); one.geometry?.dispose(); }
        if (k >= 0) this.fill(group, data.bodies[k].solids, k);
        else for (const s of data.ground) group.add(solid(s, GREY));
      },
    };
  }

  seek(t) {
    const [low, high] = [Math.min(this.first, this.last), Math.max(this.first, this.last)];
    this.now = Math.min(high, Math.max(low, t));
    this.dirty = true;
  }

  play(on) {
    if (on && this.now === this.last) this.now = this.first;
    this.playing = on && this.nt > 1;
    $("play").textContent = this.playing ? "❚❚" : "▶";
    $("play").setAttribute("aria-label", this.playing ? "Pause" : "Play");
    this.dirty = true;
    if (!on) this.say(this.clock());
  }

  say(text) { $("said").textContent = text; }

  clock() {
    const { name, unit } = this.data.abscissa, span = Math.abs(this.last - this.first);
    const digits = span > 0.5 || !span ? 2 : Math.min(12, Math.max(4, 2 - Math.floor(Math.log10(span))));
    const shown = (x) => (unit === "s" ? x.toFixed(digits) : short(x));
    return `${name === "t" ? "" : `${name} = `}${shown(this.now)} / ${shown(this.last)}${unit ? ` ${unit}` : ""}`;
  }

  tick(stamp) {
    const dt = Math.min(0.1, (stamp - (this.stamp ?? stamp)) / 1000);
    this.stamp = stamp;
    if (this.playing && !document.hidden) {
      this.now += this.sense * this.rate * dt;
      if ((this.now - this.last) * this.sense >= 0) {
        if ($("loop").checked) this.now = this.first; else { this.now = this.last; this.play(false); }
      }
      this.dirty = true;
    }
    if (this.dirty) this.draw();
  }

  draw() {
    this.dirty = false;
    const [i, k] = this.place();
    this.stage.draw();
    this.axes();
    if (this.strip) this.strip.draw(this.now, i, k);
    $("time").value = this.now;
    $("time").setAttribute("aria-valuetext", this.clock());
    $("clock").textContent = this.clock();
  }

  // the directions x, y, z in a corner
  axes() {
    const canvas = $("axes"), pen = canvas.getContext("2d"), turn = this.stage.camera.quaternion.clone().invert();
    pen.clearRect(0, 0, 128, 128);
    pen.lineWidth = 5;
    pen.font = "600 24px system-ui, sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    const ends = ["x", "y", "z"].map((name, k) => [name, new Vector3().setComponent(k, 1).applyQuaternion(turn), AXES[k]]);
    for (const [name, end, color] of ends.sort((a, b) => a[1].z - b[1].z)) {
      pen.strokeStyle = pen.fillStyle = color;
      pen.beginPath(); pen.moveTo(64, 64); pen.lineTo(64 + 38 * end.x, 64 - 38 * end.y); pen.stroke();
      pen.fillText(name, 64 + 54 * end.x, 64 - 54 * end.y);
    }
  }

  // hands

  hands() {
    const { data } = this;
    Object.assign($("time"), { min: Math.min(this.first, this.last), max: Math.max(this.first, this.last) });
    $("time").oninput = () => { this.play(false); this.seek(Number($("time").value)); };
    $("play").onclick = () => this.play(!this.playing);
    const timed = data.abscissa.unit === "s", span = Math.abs(this.last - this.first), speeds = [];
    for (let power = -9; power < 9; power++) for (const k of [1, 2, 5]) speeds.push(Number(`${k}e${power}`));
    // down to a tenth of the usual one, and up to where everything passes in some seconds
    const [least, most] = [Math.min(0.001, data.rate / 10), Math.max(10, span / 3)];
    const rates = timed ? [...new Set([...speeds.filter((x) => x >= least && x <= most), data.rate])].sort((a, b) => a - b) : [0.1, 0.2, 0.5, 1, 2, 5].map((x) => x * data.rate);
    for (const x of rates) $("rate").add(new Option(`${short(timed ? x : x / data.rate)}×`, x, x === data.rate, x === data.rate));
    $("rate").onchange = () => { this.rate = Number($("rate").value); };
    if (this.nt < 2) $("panel").hidden = true;
    if (data.histories.length && this.nt > 1) {
      $("histories").hidden = false;
      this.strip = new Strip($("strip"), element("span", { id: "legend" }), $("tabs"), data, css, (t) => { if (t !== null) { this.play(false); this.seek(t); } this.dirty = true; });
      $("tabs").append(this.strip.legend);
      $("strip").addEventListener("pointermove", (e) => {
        const box = $("strip").getBoundingClientRect(), name = this.strip.X && this.strip.event(e.clientX - box.left);
        this.tag(name, e.clientX, e.clientY - 30);
      });
      $("strip").addEventListener("pointerleave", () => this.tag(null));
    }
    this.list();
    const press = (id, act) => { $(id).onclick = act; };
    press("home", () => this.look());
    press("shot", () => this.save());
    press("dark", () => this.theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
    press("list", () => this.open("list", "scene"));
    press("help", () => this.open("help", "keys"));
    const axes = { x: new Vector3(1, 0, 0), y: new Vector3(0, -1, 0), z: new Vector3(0, 0, 1) };
    for (const [name, axis] of Object.entries(axes)) press(`along-${name}`, () => this.along(axis));
    this.keys(axes);
    this.hover();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.theme());
    addEventListener("hashchange", () => this.hash());
    $("stage").addEventListener("webglcontextrestored", () => { this.stage.surround(); this.dirty = true; });
  }

  // a second press looks from the other side
  along(axis) {
    const from = new Vector3().subVectors(this.stage.camera.position, this.stage.controls.target).normalize();
    this.look(from.dot(axis) > 0.999 ? axis.clone().negate() : axis);
  }

  // at the whole scene; where a body is followed, from where the start of the scene is with it
  look(from) {
    this.stage.look(from);
    if (!this.following) return;
    const k = this.surfaces.indexOf(this.following);
    const start = k < 0 ? new Vector3().fromArray(this.data.poses, 7 * this.bodies.indexOf(this.following)) : new Vector3().fromArray(this.data.surfaces[k].places);
    this.stage.carry(start.subVectors(this.was, start));
  }

  open(button, panel) {
    const on = $(panel).hidden;
    for (const [b, p] of [["list", "scene"], ["help", "keys"]]) { $(p).hidden = p !== panel || !on; $(b).setAttribute("aria-pressed", b === button && on); }
  }

  list() {
    const { data } = this;
    this.layers = {};
    this.switches = {};
    const layer = (name, act) => {
      const box = element("input", { type: "checkbox", id: `layer-${name}` });
      box.onchange = () => { act(box.checked); this.dirty = true; };
      this.switches[name] = (on) => { box.checked = on; act(on); this.dirty = true; };
      $("layers").append(element("label", {}, box, name));
    };
    if (data.bodies.length) layer("frames", (on) => this.triads.forEach((axes) => { axes.visible = on; }));
    for (const name of Object.keys(LAYERS)) if (data.arrows.some((a) => a.layer === name)) layer(name, (on) => { this.layers[name] = on; });
    if (data.springs.length) layer("springs", (on) => this.springs.forEach((s) => { s.removeFromParent(); if (on) this.stage.scene.add(s); }));
    if (data.scale) layer(data.scale.kind, (on) => { this.stress = on; $("scale").hidden = !on; });
    if (this.stage.floor) layer("floor", (on) => { $("cell").hidden = !on; this.stage.floor.plane.visible = this.stage.floor.grid.visible = on; });
    $("follow").add(new Option("nothing", ""));
    this.named.forEach((thing, k) => {
      const body = k < this.bodies.length;
      if (body) $("follow").add(new Option(thing.name, k));
      const n = this.surfaces.indexOf(thing);
      if (n >= 0 && data.surfaces[n].places) $("follow").add(new Option(thing.name, this.bodies.length + n));
      const show = element("input", { type: "checkbox", checked: true, ariaLabel: `show ${thing.name}` });
      show.onchange = () => { thing.visible = show.checked; this.dirty = true; };
      const trace = element("input", { type: "checkbox", ariaLabel: `trace ${thing.name}` });
      trace.onchange = () => this.toggleTrace(k, trace.checked);
      $("bodies").append(element("tr", {}, element("td", { textContent: thing.name }), element("td", {}, show), element("td", {}, ...(body && this.nt > 1 ? [trace] : []))));
    });
    $("follow").onchange = () => this.follow($("follow").value === "" ? null : this.carriers[Number($("follow").value)]);
    if (data.follow !== null) { this.pending = data.follow; $("follow").value = data.follow; }
    if (!this.named.length) $("list").hidden = true;
    const names = this.named.map((thing) => thing.name).join(", ");
    $("stage").setAttribute("aria-label", `3-D view of ${data.name}: ${names}. Space plays, arrow keys step, ? lists the keys.`);
    if (data.scale) {
      $("scale-name").textContent = `${data.scale.name} [${data.scale.unit}]`;
      $("least").textContent = "0";
      $("most").textContent = short(data.scale.shown);
      const pen = document.querySelector("#scale canvas").getContext("2d"), tone = { setRGB: (r, g, b) => `rgb(${[r, g, b].map((x) => Math.round(255 * x))})` };
      for (let x = 0; x < 190; x++) { pen.fillStyle = shade(x / 189, tone); pen.fillRect(x, 0, 1, 1); }
    }
  }

  layersOn(names) {
    for (const [name, set] of Object.entries(this.switches)) set(names.includes(name));
    if (this.pending !== undefined) { this.place(); this.follow(this.carriers[this.pending]); }
  }

  follow(group) {
    this.following = group;
    this.was = group && group.position.clone();
    this.dirty = true;
  }

  keys(axes) {
    const step = () => Math.max(Math.abs(this.last - this.first) / 400, 1e-12), click = (id) => () => $(id) && $(id).click();
    const next = (by) => () => { const s = $("rate"); s.selectedIndex = Math.min(s.options.length - 1, Math.max(0, s.selectedIndex + by)); s.onchange(); };
    const stop = (t) => { this.play(false); this.seek(t); };
    const keys = {
      " ": ["Space", "play or pause", () => this.play(!this.playing)],
      ArrowRight: ["→ ←", "step; with Shift ten steps", (e) => stop(this.now + this.sense * step() * (e.shiftKey ? 10 : 1))],
      ArrowLeft: [null, null, (e) => stop(this.now - this.sense * step() * (e.shiftKey ? 10 : 1))],
      ArrowUp: ["↑ ↓", "faster, slower", next(1)],
      ArrowDown: [null, null, next(-1)],
      Home: ["Home End", "start, end", () => stop(this.first)],
      End: [null, null, () => stop(this.last)],
      a: ["A D W S", "turn; with Shift move", () => this.stage.orbit(-0.1, 0)],
      d: [null, null, () => this.stage.orbit(0.1, 0)],
      w: [null, null, () => this.stage.orbit(0, 0.1)],
      s: [null, null, () => this.stage.orbit(0, -0.1)],
      A: [null, null, () => this.stage.shift(-0.03, 0)],
      D: [null, null, () => this.stage.shift(0.03, 0)],
      W: [null, null, () => this.stage.shift(0, 0.03)],
      S: [null, null, () => this.stage.shift(0, -0.03)],
      "+": ["+ −", "nearer, farther", () => this.stage.zoom(0.9)],
      "=": [null, null, () => this.stage.zoom(0.9)],
      "-": [null, null, () => this.stage.zoom(1 / 0.9)],
      0: ["0", "whole scene", () => this.look()],
      1: ["1 2 3", "view along x, y, z; again from behind", () => this.along(axes.x)],
      2: [null, null, () => this.along(axes.y)],
      3: [null, null, () => this.along(axes.z)],
      f: ["F", "frames", click("layer-frames")],
      r: ["R", "reactions", click("layer-reactions")],
      b: ["B", "bodies and layers", click("list")],
      n: ["N", "dark or light", click("dark")],
      p: ["P", "save a picture", () => this.save()],
      "?": ["?", "these keys", click("help")],
    };
    for (const [label, what] of Object.values(keys)) if (label) document.querySelector("#keys dl").append(element("dt", { textContent: label }), element("dd", { textContent: what }));
    addEventListener("keydown", (e) => {
      const writes = /^(SELECT|TEXTAREA)$/.test(e.target.tagName) || (e.target.tagName === "INPUT" && e.target.type !== "range");
      if (e.ctrlKey || e.metaKey || e.altKey || (writes && e.key !== "?")) return;
      if (e.key === " " && e.target.tagName === "BUTTON") return;
      const found = Object.hasOwn(keys, e.key) && keys[e.key];
      if (found) { e.preventDefault(); found[2](e); this.dirty = true; }
    });
  }

  hover() {
    const canvas = $("stage");
    let waiting = 0;
    canvas.addEventListener("pointermove", (e) => {
      clearTimeout(waiting);
      if (e.buttons) { this.tag(null); return; }
      waiting = setTimeout(() => this.tag(this.nameAt(e.clientX, e.clientY), e.clientX, e.clientY), 40);
    });
    canvas.addEventListener("pointerleave", () => { clearTimeout(waiting); this.tag(null); });
  }

  nameAt(x, y) {
    const hit = this.stage.under(x, y, [...this.named.filter((thing) => thing.visible), ...this.springs.filter((s) => s.parent), this.ground]);
    let thing = hit && hit.object;
    while (thing && !thing.name) thing = thing.parent;
    return thing ? thing.name : null;
  }

  tag(text, x, y) {
    $("tag").hidden = !text;
    if (!text) return;
    $("tag").textContent = text;
    $("tag").style.transform = `translate(${Math.min(x + 14, innerWidth - 140)}px, ${y + 12}px)`;
  }

  save() {
    this.draw();
    const link = element("a", { href: $("stage").toDataURL("image/png"), download: `${this.data.name} ${short(this.now)}.png` });
    link.click();
  }

  theme(choice) {
    const dark = choice ? choice === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    $("dark").setAttribute("aria-pressed", dark);
    this.stage.color(css);
    if (this.strip) this.strip.still = null;
    this.dirty = true;
  }

  resize() {
    this.stage.resize();
    if (this.strip) this.strip.still = null;
    if (!this.seen) { this.seen = true; this.stage.look(); }
    this.draw();
  }

  // page.html#t=2.5&show=reactions,frames&theme=dark&view=x&bare
  hash() {
    const asked = new URLSearchParams(location.hash.slice(1));
    if (asked.has("t")) { this.paused = true; this.play(false); this.seek(Number(asked.get("t")) || this.first); }
    if (asked.has("show")) for (const name of asked.get("show").split(",")) if (Object.hasOwn(this.switches, name)) this.switches[name](true);
    if (asked.has("theme")) this.theme(asked.get("theme"));
    if (asked.has("bare")) { document.body.dataset.bare = ""; this.resize(); this.look(); }
    if (asked.has("view")) $(`along-${asked.get("view")}`)?.click();
  }
}

try {
  const data = await load(), page = new Page(data);
  // for programs that drive the page
  window.cardan = {
    seek: (t) => { page.play(false); page.seek(t); page.draw(); },
    play: (on) => page.play(on),
    project: (point) => page.stage.project(point),
    position: (name) => page.bodies[data.bodies.findIndex((body) => body.name === name)].position.toArray(),
    point: (name, k) => page.surfaces[data.surfaces.findIndex((one) => one.name === name)].point(k),
    get time() { return page.now; },
    get camera() { return page.stage.camera.position.toArray(); },
    get target() { return page.stage.controls.target.toArray(); },
    get rate() { return page.rate; },
  };
  if (data.live) await startLive(data, page.viewer());
  document.body.dataset.ready = "";
} catch (problem) {
  $("trouble").hidden = false;
  $("trouble").textContent = /webgl|context/i.test(String(problem)) ? "This browser does not draw in 3-D (WebGL). Write the page with page=\"plain\"." : `This page cannot be shown: ${problem}`;
  throw problem;
}
