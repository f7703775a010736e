
/** No finite result: a linear system without a solution, or a number outside a domain. */
export class SolveError extends Error {
  name = "SolveError";
}

/** Compile the functions.
 *
 * @param {{model?: BufferSource, kernels?: BufferSource}} files Contents of the WebAssembly files;
 *   by default what lies beside this one.
 * @returns {Promise<Model>} A model with the parameters of the scene.
 */
export async function load(files = {}) {
  const [kernels, model] = await Promise.all([
    files.kernels ?? content(KERNELS_FILE),
    files.model ?? content(MODEL_FILE),
  ]);
  const core = (await WebAssembly.instantiate(kernels)).instance.exports;
  core._initialize();
  grow(core.memory, END);
  const { instance } = await WebAssembly.instantiate(model, { kernels: { ...core } });
  return new Model(core.memory, instance.exports);
}

/** Make room up to an address. */
function grow(memory, end) {
  const missing = end - memory.buffer.byteLength;
  if (missing > 0) memory.grow(Math.ceil(missing / 65536));
}

/** Bytes of a file that lies beside this one. */
async function content(name) {
  const url = new URL(name, import.meta.url);
  // fetch of node reads no files
  if (url.protocol === "file:") return (await import("node:fs/promises")).readFile(url);
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url} cannot be read: ${answer.status} ${answer.statusText}`);
  return answer.arrayBuffer();
}

/** Names for a message. */
function listed(names) {
  return names.slice(0, 12).join(", ") + (names.length > 12 ? ", ..." : "");
}

/** A value for a message. */
function kind(value) {
  return typeof value === "number" ? `${value}` : `of type ${typeof value}`;
}

/** Names of the entries of a block, as far as it has any; v has others in every function. */
function namesOf(where, block) {
  return block === "v" ? FUNCTIONS[where].vector : NAMES[block];
}

/** Numbers of a block, checked. */
function numbers(where, block, value) {
  const names = namesOf(where, block) ?? [], size = block === "v" ? names.length : SIZES[block];
  const isList = Array.isArray(value) || (ArrayBuffer.isView(value) && "length" in value);
  const values = block === "t" ? [value] : isList ? value : byName(where, block, value);
  if (values.length !== size) {
    const entries = names.length ? `: ${listed(names)}` : "";
    throw new RangeError(`${where}: ${block} has length ${values.length}, not ${size}${entries}`);
  }
  for (let k = 0; k < size; k++) {
    if (Number.isFinite(values[k])) continue;
    const entry = block === "t" ? "t" : `${block}[${k}]${names.length ? ` (${names[k]})` : ""}`;
    throw new TypeError(
      `${where}: ${entry} is ${kind(values[k])}. Every number given must be finite`);
  }
  return values;
}

/** Numbers of a block at the start of the scene, some of which are others. */
function byName(where, block, value) {
  const names = namesOf(where, block), size = block === "v" ? names.length : SIZES[block];
  if (value === null || typeof value !== "object" || names === undefined) {
    const or = names ? ", or an object with values by name" : "";
    throw new TypeError(`${where}: ${block}: give an array of ${size} numbers${or}`);
  }
  const found = Array.from(DEFAULTS[block] ?? new Float64Array(size));
  for (const [name, number] of value instanceof Map ? value : Object.entries(value)) {
    const k = names.indexOf(name);
    if (k < 0) {
      const hint = names.length ? `Known: ${listed(names)}` : "There are none";
      throw new TypeError(`${where}: ${block} has no ${JSON.stringify(name)}. ${hint}`);
    }
    found[k] = number;
  }
  return found;
}

/** The model: its functions work on numbers in the memory of the kernels. */
class Model {
  #exports; // the functions
  #memory;
  #numbers; // the memory as doubles
  #pointers; // the memory as addresses
  #end = END; // first address that is free
  #in; // pointers to the blocks
  #at = {}; // addresses of the blocks
  #out;
  #work;
  #w = {}; // addresses of prepared parameters, by function
  #prepared = new Set(); // functions whose prepared parameters are up to date

  constructor(memory, exports) {
    this.#memory = memory;
    this.#exports = exports;
    this.#in = this.#reserve(4 * (1 + Math.max(...Object.values(SLOTS))));
    for (const block of Object.keys(SLOTS)) this.#at[block] = this.#doubles(SIZES[block]);
    const rows = Object.entries(FUNCTIONS);
    this.#out = this.#doubles(Math.max(...rows.map(([, row]) => row.out)));
    this.#work = this.#doubles(Math.max(...rows.map(([, row]) => row.work)));
    for (const [name, row] of rows) this.#w[name] = this.#doubles(row.w);
    // from here on the memory stays as large as it is
    this.#numbers = new Float64Array(memory.buffer);
    this.#pointers = new Uint32Array(memory.buffer);
    for (const block of Object.keys(SLOTS)) this.#point(block, this.#at[block]);
    this.prepare();
  }

  #reserve(bytes) {
    const address = this.#end;
    this.#end += 16 * Math.ceil(bytes / 16);
    grow(this.#memory, this.#end);
    return address;
  }

  #doubles(count) {
    return this.#reserve(8 * Math.max(count, 1));
  }

  /** Tell functions where a block begins. */
  #point(block, address) {
    this.#pointers[this.#in / 4 + SLOTS[block]] = address;
  }

  /** Take other parameters from now on: once for all calls with the same ones.
   *
   * @param {Object<string, number> | Map<string, number> | ArrayLike<number>} parameters Values by
   *   name, the others are those of the scene; or all of them; by default those of the scene.
   * @returns {this}
   */
  prepare(parameters = {}) {
    this.#numbers.set(numbers("prepare", "p", parameters), this.#at.p / 8);
    this.#prepared.clear();
    return this;
  }

  /** Results of a function, one after the other. */
  #call(name, blocks) {
    const { takes, needs } = FUNCTIONS[name];
    if (blocks === null || typeof blocks !== "object" || Array.isArray(blocks)) {
      const all = takes.map((block) => `${block}: ...`).join(", ");
      throw new TypeError(`${name}: give an object { ${all} }`);
    }
    for (const block of Object.keys(blocks)) {
      if (!takes.includes(block)) {
        throw new TypeError(`${name} takes no '${block}'. Known: ${takes.join(", ")}`);
      }
    }
    for (const block of takes) {
      if (blocks[block] === undefined && needs.includes(block)) {
        throw new TypeError(`${name} needs ${block}`);
      }
      this.#write(name, block, blocks[block]);
    }
    return this.#results(name);
  }

  /** Put the numbers of a block where the functions look for them. */
  #write(name, block, value) {
    const values = value === undefined ? DEFAULTS[block] : numbers(name, block, value);
    let first = 0;
    for (const part of block === "x" ? ["q", "u", "z"] : [block]) {
      const size = part === "v" ? values.length : SIZES[part], start = this.#at[part] / 8;
      for (let k = 0; k < size; k++) this.#numbers[start + k] = values?.[first + k] ?? 0;
      first += size;
    }
  }

  /** Run a function on the blocks as they are. */
  #results(name) {
    const { out, entries } = FUNCTIONS[name];
    if (!this.#prepared.has(name)) {
      this.#exports[`prepare_${name}`](this.#at.p, this.#w[name]);
      this.#prepared.add(name);
    }
    this.#point("w", this.#w[name]);
    const status = this.#exports[name](this.#in, this.#out, this.#work);
    const results = this.#numbers.slice(this.#out / 8, this.#out / 8 + out);
    const bad = results.findIndex((x) => !Number.isFinite(x));
    if (status || bad >= 0) {
      const what = entries[bad] === undefined ? "" : ` for ${entries[bad]}`;
      const code = status ? ` (status ${status})` : "";
      throw new SolveError(
        `${name} has no finite result${what}${code}: the mass matrix is singular there (a massless ` +
        "body?) or a coordinate is outside its domain");
    }
    return results;
  }
__FUNCTIONS__}
