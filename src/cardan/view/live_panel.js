// Hands on a model that runs in the page: sliders, reset, a link to share, pulling, histories, time.
// `viewer` draws: place(poses), pick(x, y), across(x, y, point), hold(on), trail(k, points), line(ends).

const WINDOW = 10; // seconds of history that show
const PULL = { rate: 9, damping: 0.7 }; // of the spring of a hand on the mass that it feels [rad/s]
const TRAIL = 600;
const ENDED = {
  4: "An event ended the motion.", "-1": "The motion is no longer finite.", "-2": "The step became too small.",
  "-3": "The equations have no solution here.", "-6": "The loops do not close.", "-9": "Events go on and on at one time.",
  "-10": "An event happens over and over.",
};

// A number of four digits that fits beside a history.
const short = (y) => (y && (Math.abs(y) < 1e-3 || Math.abs(y) >= 1e5) ? y.toExponential(1) : String(Number(y.toPrecision(4))));

class LivePanel {
  constructor(model, spec, viewer) {
    Object.assign(this, { model, spec, viewer, playing: true, rate: 1, spent: 0, frames: 0, pulled: null });
    this.bodies = spec.bodies.length;
    this.trails = spec.traces.map(() => []);
    this.build();
    this.hash();
    this.hands();
    this.restart();
    const loop = (stamp) => { this.tick(stamp); requestAnimationFrame(loop); };
    requestAnimationFrame(loop);
  }

  // what stands in the panel

  build() {
    const make = (tag, more = {}, ...inner) => { const made = Object.assign(document.createElement(tag), more); made.append(...inner); return made; };
    this.clock = make("output");
    this.said = make("p", { id: "live-said", role: "status" });
    this.button = make("button", { type: "button", title: "Space", onclick: () => this.play(!this.playing) });
    const reset = make("button", { type: "button", textContent: "Reset", onclick: () => this.restart() });
    const share = make("button", { type: "button", textContent: "Share", title: "A link with these values", onclick: () => this.share() });
    const rate = make("select", { ariaLabel: "Speed", onchange: () => { this.rate = Number(rate.value); } });
    for (const x of [0.1, 0.25, 0.5, 1, 2, 4]) rate.add(new Option(`${x}×`, x, x === 1, x === 1));
    this.rows = this.spec.sliders.map((slider) => {
      const range = make("input", { type: "range", min: slider.low, max: slider.high, step: "any", value: slider.value, ariaLabel: slider.name });
      const value = make("output", { htmlFor: range.id });
      const row = { ...slider, range, value, shown: slider.value };
      range.oninput = () => { row.wanted = Number(range.value); };
      this.show(row);
      this.sliders ??= make("div", { id: "live-sliders" });
      this.sliders.append(make("label", { textContent: slider.name }), range, value);
      return row;
    });
    const buttons = make("div", { id: "live-buttons" }, this.button, reset, share, rate, this.clock);
    const details = make("details", { open: innerWidth > 640 }, make("summary", { textContent: "Live" }), ...(this.sliders ? [this.sliders] : []), buttons, this.said);
    document.getElementById("live").append(details);
    this.strip = make("canvas", { id: "live-strip", role: "img", ariaLabel: "Histories" });
    this.legend = make("div", { id: "live-legend" });
    this.tabs = this.spec.plots.map((plot, k) => make("button", { type: "button", textContent: plot.unit ? `${plot.name} [${plot.unit}]` : plot.name, onclick: () => this.choose(k) }));
    const bar = make("footer", { id: "live-bar", hidden: !this.tabs.length }, make("div", { id: "live-tabs" }, ...(this.tabs.length > 1 ? this.tabs : [make("span", { textContent: this.tabs[0]?.textContent ?? "" })]), this.legend), this.strip);
    document.body.append(bar);
    this.histories = this.spec.plots.map((plot) => ({ t: [], y: plot.curves.map(() => []) }));
    this.choose(0);
  }

  choose(k) {
    this.chosen = k;
    this.tabs.forEach((tab, j) => tab.setAttribute("aria-selected", j === k));
    this.legend.replaceChildren(...(this.spec.plots[k]?.curves ?? []).map((_, j) => {
      const entry = document.createElement("span");
      entry.style.setProperty("--c", this.color(j));
      return entry;
    }));
  }

  color(k) { return ["#2f6fde", "#e07b39", "#3a9d6e", "#b5508f", "#c9a227", "#5b6ee1"][k % 6]; }

  show(row) {
    row.value.textContent = `${Number(row.shown.toPrecision(4))}${row.unit ? ` ${row.unit}` : ""}`;
  }

  say(text) { this.said.textContent = text; }

  play(on) {
    this.playing = on;
    this.button.textContent = on ? "❚❚" : "▶";
    this.button.setAttribute("aria-label", on ? "Pause" : "Play");
  }

  // the start, at the values of the sliders
  restart() {
    const { model, spec } = this;
    model.p.set(spec.parameters);
    model.prepare();
    model.start();
    for (const row of this.rows) { row.wanted = row.shown; this.set(row); }
    this.trails.forEach((points) => { points.length = 0; });
    this.histories.forEach((history) => { history.t.length = 0; history.y.forEach((y) => { y.length = 0; }); });
    this.pulled = null;
    this.say("");
    this.play(true);
    this.draw();
  }

  // a slider to the value that is wanted
  set(row) {
    const { wanted } = row;
    row.wanted = undefined;
    if (row.kind === "input") { this.model.r[row.index] = wanted; row.shown = wanted; }
    else if (this.model.change(row.index, wanted)) { row.shown = wanted; this.say(""); }
    else { row.shown = this.model.p[row.index]; this.say(`It cannot be assembled with ${row.name} = ${Number(wanted.toPrecision(4))}.`); }
    row.range.value = row.shown;
    this.show(row);
    this.reshape();
    this.dirty = true;
  }

  // solids whose size hangs on sliders: what every slider adds to the usual values
  reshape() {
    const { shapes } = this.spec, usual = (entry) => this.value(entry, this.spec.sliders[entry.slider].value);
    const solids = new Map();
    for (const entry of shapes) {
      const key = `${entry.body} ${entry.solid} ${entry.field}`, before = usual(entry), now = this.value(entry, this.rows[entry.slider].shown);
      const sum = solids.get(key) ?? { ...entry, value: before };
      sum.value = [sum.value, before, now].some(Array.isArray) ? sum.value.map((x, i) => x + now[i] - before[i]) : sum.value + now - before;
      solids.set(key, sum);
    }
    for (const { body, solid, field, value } of solids.values()) this.viewer.solids(body)[solid][field] = value;
    for (const body of new Set(shapes.map((entry) => entry.body))) this.viewer.reshaped(body);
  }

  // values of a field between those that were looked at
  value({ at, values }, x) {
    let k = 0;
    while (k < at.length - 2 && at[k + 1] < x) k++;
    const f = Math.min(1, Math.max(0, (x - at[k]) / (at[k + 1] - at[k]))), [a, b] = [values[k], values[k + 1]];
    return Array.isArray(a) ? a.map((y, i) => y + f * (b[i] - y)) : a + f * (b - a);
  }

  tick(stamp) {
    const dt = Math.min(0.05, (stamp - (this.stamp ?? stamp)) / 1000) * this.rate;
    this.stamp = stamp;
    const before = performance.now();
    for (const row of this.rows) if (row.wanted !== undefined) this.set(row);
    if (this.playing && dt > 0 && !document.hidden) {
      if (this.pulled) this.drag();
      const status = this.model.advance(dt);
      if (status !== 0) { this.play(false); this.say(`${ENDED[status] ?? `The motion ended (${status}).`} Press Reset.`); }
      this.note();
      this.dirty = true;
    }
    if (this.dirty || this.viewer.changed()) this.draw();
    this.spent = 0.95 * this.spent + 0.05 * (performance.now() - before);
    this.frames += 1;
  }

  // histories and trails

  note() {
    const { model, spec } = this, now = model.t;
    this.poses = model.frames();
    spec.plots.forEach((plot, k) => {
      const history = this.histories[k], results = {};
      history.t.push(now);
      plot.curves.forEach((curve, j) => {
        results[curve.of] ??= curve.of === "x" ? model.x : model.call(curve.of).slice();
        history.y[j].push(results[curve.of][curve.index]);
      });
      while (history.t[0] < now - WINDOW) { history.t.shift(); history.y.forEach((y) => y.shift()); }
    });
    this.trails.forEach((points, k) => {
      const at = 18 * (this.bodies + k) + 9;
      points.push([...this.poses.subarray(at, at + 3)]);
      if (points.length > TRAIL) points.shift();
    });
  }

  draw() {
    this.dirty = false;
    this.poses = this.model.frames();
    this.viewer.place(this.poses);
    this.trails.forEach((points, k) => this.viewer.trail(k, points));
    this.viewer.line(this.pulled && [this.grip(), this.pulled.target]);
    this.viewer.draw();
    this.clock.textContent = `${this.model.t.toFixed(2)} s`;
    this.clock.title = `${this.spent.toFixed(2)} ms a frame`;
    this.plot();
  }

  plot() {
    const { strip } = this, history = this.histories[this.chosen];
    if (!history || !strip.clientWidth) return;
    const ratio = devicePixelRatio || 1, width = strip.clientWidth, height = strip.clientHeight, pen = strip.getContext("2d");
    if (strip.width !== Math.round(width * ratio)) { strip.width = Math.round(width * ratio); strip.height = Math.round(height * ratio); }
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    const all = history.y.flat().filter(Number.isFinite);
    let [low, high] = [Infinity, -Infinity];
    for (const y of all) { low = Math.min(low, y); high = Math.max(high, y); }
    if (low > high) return;
    const margin = 0.08 * (high - low) || Math.abs(high) * 0.05 || 1;
    low -= margin; high += margin;
    const end = Math.max(this.model.t, WINDOW), X = (t) => 60 + ((width - 70) * (t - end + WINDOW)) / WINDOW, Y = (y) => 6 + ((height - 12) * (high - y)) / (high - low);
    pen.font = "11px system-ui, sans-serif";
    pen.fillStyle = getComputedStyle(strip).color;
    pen.textAlign = "right";
    for (const y of [low + margin, high - margin]) pen.fillText(short(y), 54, Y(y) + 4);
    pen.lineWidth = 1.7;
    history.y.forEach((y, j) => {
      pen.strokeStyle = this.color(j);
      pen.beginPath();
      history.t.forEach((t, i) => pen[i ? "lineTo" : "moveTo"](X(t), Y(y[i])));
      pen.stroke();
      const { name } = this.spec.plots[this.chosen].curves[j];
      this.legend.children[j].textContent = `${name} ${y.length ? short(y[y.length - 1]) : ""}`;
    });
  }

  // a hand: a spring from the point that was gripped to the pointer

  grip() {
    const { k, local } = this.pulled, f = this.poses.subarray(18 * k, 18 * k + 18);
    return [0, 1, 2].map((i) => f[9 + i] + f[3 * i] * local[0] + f[3 * i + 1] * local[1] + f[3 * i + 2] * local[2]);
  }

  take(k, point) {
    this.poses = this.model.frames();
    const f = this.poses.subarray(18 * k, 18 * k + 18), d = [0, 1, 2].map((i) => point[i] - f[9 + i]);
    const local = [0, 1, 2].map((j) => f[j] * d[0] + f[3 + j] * d[1] + f[6 + j] * d[2]);
    this.pulled = { k, local, target: point };
  }

  drag() {
    const { k, target } = this.pulled, { model } = this, point = this.grip(), stretch = target.map((x, i) => x - point[i]);
    const length = Math.hypot(...stretch);
    if (!(length > 0)) { model.pull(k, point, null); return; }
    const direction = stretch.map((x) => x / length), mass = model.felt(k, point, direction);
    if (!Number.isFinite(mass)) return;
    model.pull(k, point, null);
    const v = model.velocity(k, point), { rate, damping } = PULL;
    model.pull(k, point, stretch.map((x, i) => mass * (rate * rate * x - 2 * damping * rate * v[i])));
  }

  release() {
    if (this.pulled) this.model.pull(0, [0, 0, 0], null);
    this.pulled = null;
    this.dirty = true;
  }

  hands() {
    const stage = document.getElementById("stage"), { viewer } = this;
    stage.addEventListener("pointerdown", (e) => {
      if (!this.spec.drag || e.button !== 0 || e.shiftKey) return;
      const hit = viewer.pick(e.clientX, e.clientY);
      if (!hit) return;
      e.stopImmediatePropagation();
      stage.setPointerCapture(e.pointerId);
      viewer.hold(true);
      this.take(hit.body, hit.point);
      if (!this.playing) this.play(true);
    }, true);
    stage.addEventListener("pointermove", (e) => {
      if (!this.pulled) return;
      e.stopImmediatePropagation();
      this.pulled.target = viewer.across(e.clientX, e.clientY, this.pulled.target);
      this.dirty = true;
    }, true);
    for (const name of ["pointerup", "pointercancel"]) stage.addEventListener(name, () => { viewer.hold(false); this.release(); }, true);
    addEventListener("keydown", (e) => {
      if (e.code !== "Space" || /^(BUTTON|SELECT|SUMMARY)$/.test(e.target.tagName)) return;
      e.preventDefault();
      e.stopImmediatePropagation();
      this.play(!this.playing);
    }, true);
    addEventListener("hashchange", () => { this.hash(); this.restart(); });
    addEventListener("resize", () => { this.dirty = true; });
  }

  // page.html#m=2&l=0.5

  hash() {
    const asked = new URLSearchParams(location.hash.slice(1));
    for (const row of this.rows) {
      const text = asked.get(row.key), value = Number(text);
      if (!text || !Number.isFinite(value)) continue;
      row.shown = Math.min(row.high, Math.max(row.low, value));
      row.range.value = row.shown;
      this.show(row);
    }
  }

  async share() {
    const values = new URLSearchParams(location.hash.slice(1));
    for (const row of this.rows) values.set(row.key, String(Number(row.shown.toPrecision(6))));
    const link = `${location.href.split("#")[0]}#${values}`;
    history.replaceState(null, "", link);
    try { await navigator.clipboard.writeText(link); this.say("The link is copied."); } catch { this.say("The address of this page holds the values now."); }
  }
}

async function runLive(data, viewer) {
  const [kernels, functions] = [await inflated("live-kernels"), await inflated("live-model")];
  const model = new LiveModel(data.live, kernels, functions), panel = new LivePanel(model, data.live, viewer);
  window.cardan = { ...window.cardan, live: model, panel };
  document.body.dataset.live = "";
}
