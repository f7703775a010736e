// A model that runs in the page: the kernels and its functions are WebAssembly in one memory.

class LiveModel {
  // spec: what cardan.view.live_page says of it; kernels, functions: modules as bytes
  constructor(spec, kernels, functions) {
    this.spec = spec;
    const core = new WebAssembly.Instance(new WebAssembly.Module(kernels), {}).exports;
    core._initialize();
    const { memory } = core, table = core.__indirect_function_table;
    Object.assign(this, { core, memory, table, end: spec.end });
    if (table.length < spec.table) table.grow(spec.table - table.length);
    this.reserve(0);
    new WebAssembly.Instance(new WebAssembly.Module(functions), { kernels: { memory, table, ...core } });
    const fields = spec.records.cardan_export, field = (name) => this.int(spec.scene + fields[name]);
    const sizes = {};
    for (const name of ["nq", "nu", "nz", "ns", "nr", "zeros"]) sizes[name] = field(name);
    this.sizes = sizes;
    this.nx = sizes.nq + sizes.nu + sizes.nz;
    this.forces = sizes.nr - sizes.nu; // where generalized forces of a hand begin among the inputs
    this.at = { // addresses of arrays
      p: this.doubles(spec.parameters.length), x: this.doubles(this.nx), s: this.doubles(sizes.ns),
      r: this.doubles(sizes.nr), u: this.doubles(sizes.nu), t: this.doubles(1),
      out: this.doubles(Math.max(...Object.values(spec.functions).map(([, n]) => n))),
      work: this.doubles(core.cardan_work_length(spec.scene)),
      in: this.reserve(4 * spec.slots.length),
      settings: this.reserve(spec.settings),
    };
    this.prepared = this.reserve(core.cardan_prepared_size(spec.scene));
    // what a run takes hangs on the model alone
    this.run = this.reserve(core.cardan_simulation_size(spec.scene, this.at.settings));
    this.p.set(spec.parameters);
    this.prepare();
    this.start();
  }

  // memory

  reserve(bytes) {
    const at = this.end;
    this.end += Math.ceil(bytes / 16) * 16;
    const missing = this.end - this.memory.buffer.byteLength;
    if (missing > 0) this.memory.grow(Math.ceil(missing / 65536));
    return at;
  }
  doubles(count) { return this.reserve(8 * Math.max(count, 1)); }
  int(at) { return new DataView(this.memory.buffer).getInt32(at, true); }
  array(at, count) { return new Float64Array(this.memory.buffer, at, count); }
  get p() { return this.array(this.at.p, this.spec.parameters.length); }
  get x() { return this.array(this.at.x, this.nx); }
  get s() { return this.array(this.at.s, this.sizes.ns); }
  get r() { return this.array(this.at.r, this.sizes.nr); }

  // the state

  start() {
    this.t = 0;
    this.x.set(this.spec.start.x);
    this.s.set(this.spec.start.s);
    const r = this.r.slice(0, this.forces);
    this.r.fill(0);
    this.r.set(this.started ? r : this.spec.inputs);
    this.started = true;
  }

  // from t to t + dt; returns an answer of run.h, 0 where all is well
  advance(dt) {
    const { settings } = this.at, fields = this.spec.records.cardan_simulation, view = new DataView(this.memory.buffer);
    for (let k = 0; k < this.spec.settings; k += 4) view.setInt32(settings + k, 0, true);
    for (const name of ["p", "x", "s", "r"]) view.setInt32(settings + fields[name], this.at[name], true);
    const numbers = { start: this.t, end: dt ? this.free(this.t + dt) : this.t, rtol: this.spec.rtol, atol: this.spec.atol };
    for (const [name, value] of Object.entries(numbers)) view.setFloat64(settings + fields[name], value, true);
    const status = this.core.cardan_simulate(this.spec.scene, settings, this.run);
    if (status >= 0) {
      this.x.set(this.array(this.int(settings + fields.x_end), this.nx));
      this.s.set(this.array(this.int(settings + fields.s_end), this.sizes.ns));
      this.t = new DataView(this.memory.buffer).getFloat64(settings + fields.t, true);
    }
    return status;
  }

  // a time near t at which nothing is sampled: runs sample where they start and where they end
  free(t) {
    const { ticks } = this.spec, aside = 1e-3 * Math.min(...ticks.map(([period]) => period));
    const near = ([period, phase]) => { const k = (t - phase) / period; return Math.abs(k - Math.round(k)) < 1e-5; };
    while (ticks.some(near)) t += aside;
    return t;
  }

  prepare() { this.core.cardan_prepare(this.spec.scene, this.at.p, this.prepared); }

  // results of a function at the present state, or at other speeds; valid until the next call
  call(name, u = null) {
    const [k, count] = this.spec.functions[name], view = new DataView(this.memory.buffer), { at, sizes } = this;
    this.array(at.t, 1)[0] = this.t;
    const blocks = {
      t: at.t, q: at.x, u: u ?? at.x + 8 * sizes.nq, z: at.x + 8 * (sizes.nq + sizes.nu), s: at.s, r: at.r,
      w: this.core.cardan_prepared_w(this.spec.scene, this.prepared, k),
    };
    for (const [name, address] of Object.entries(blocks)) view.setInt32(at.in + 4 * this.spec.slots.indexOf(name), address, true);
    const rows = this.int(this.spec.scene + this.spec.records.cardan_export.functions);
    const status = this.table.get(this.int(rows + this.spec.exported.size * k + this.spec.exported.function))(at.in, at.out, at.work);
    const results = this.array(at.out, count);
    // a function that fails, such as at a singular place, has no numbers
    return status === 0 ? results : results.fill(NaN);
  }

  // where frames are and how they move: 18 numbers each
  frames(u = null) { return this.call("frames", u).slice(); }

  // parameters go to what is asked for in small steps, so that loops stay closed: from the start to the end
  change(k, value) {
    const before = this.p[k], x = this.x.slice(), steps = this.spec.closed ? 24 : 1;
    if (value === before) return true;
    for (let i = 1; i <= steps; i++) {
      this.p[k] = i < steps ? before + (value - before) * (i / steps) : value;
      if (this.spec.closed && this.close() < 0) {
        this.p[k] = before;
        this.x.set(x);
        this.close();
        this.prepare();
        return false;
      }
    }
    this.prepare();
    return true;
  }

  // coordinates and speeds onto the constraints: the start of a run does that, and what else it does is undone
  close() {
    const s = this.s.slice(), status = this.advance(0);
    this.s.set(s);
    return status;
  }

  // generalized forces of a force (3) that pulls frame k at a point of it in ground axes
  pull(k, point, force) {
    const { nu } = this.sizes, forces = this.r.subarray(this.forces), u = this.array(this.at.u, nu);
    forces.fill(0);
    if (!force) return;
    u.fill(0);
    const still = this.velocity(k, point, this.at.u);
    const along = [];
    for (let i = 0; i < nu; i++) {
      u.fill(0);
      u[i] = 1;
      const v = this.velocity(k, point, this.at.u);
      along.push(force[0] * (v[0] - still[0]) + force[1] * (v[1] - still[1]) + force[2] * (v[2] - still[2]));
    }
    forces.set(along);
  }

  // velocity of a point (ground axes) that moves with frame k
  velocity(k, point, u = null) {
    const f = this.call("frames", u).subarray(18 * k, 18 * k + 18), w = f.subarray(12, 15), v = f.subarray(15, 18);
    const d = [point[0] - f[9], point[1] - f[10], point[2] - f[11]];
    return [v[0] + w[1] * d[2] - w[2] * d[1], v[1] + w[2] * d[0] - w[0] * d[2], v[2] + w[0] * d[1] - w[1] * d[0]];
  }

  // mass that a pull along a direction (3) feels at a point of frame k
  felt(k, point, direction) {
    const { nq, nu } = this.sizes;
    this.pull(k, point, null);
    const still = this.call("rhs").slice(nq, nq + nu);
    this.pull(k, point, direction);
    const along = this.r.slice(this.forces), moved = this.call("rhs").slice(nq, nq + nu);
    this.pull(k, point, null);
    let response = 0;
    for (let i = 0; i < nu; i++) response += along[i] * (moved[i] - still[i]);
    return response > 0 ? 1 / response : Infinity;
  }
}
