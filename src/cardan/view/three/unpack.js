// Numbers of the page: one deflated block, in which every array stands as differences along its
// first axis, rounded to steps, their bytes sorted by weight. packing.py writes it.

async function inflate(id) {
  const raw = Uint8Array.from(atob(document.getElementById(id).textContent.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([raw]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// a Float64Array with `columns`, from { at, rows, columns, step, orders }
function unpacked(bytes, { at, rows, columns, step, orders, first = 0, stretch = 0, origin = null }) {
  const n = rows * columns, whole = new Int32Array(n), values = new Float64Array(n);
  for (let i = 0; i < n; i++) {
    const z = bytes[at + i] | (bytes[at + n + i] << 8) | (bytes[at + 2 * n + i] << 16) | (bytes[at + 3 * n + i] << 24);
    whole[i] = (z >>> 1) ^ -(z & 1);
  }
  for (let order = 0; order < orders; order++)
    for (let i = columns * (orders - order); i < n; i++) whole[i] += whole[i - columns];
  for (let i = 0; i < n; i++) values[i] = first + (origin ? origin[i % columns] : 0) + whole[i] * step;
  // places: three numbers of a position, four of a quaternion
  if (stretch) for (let i = 0; i < n; i++) if (i % 7 > 2) values[i] /= stretch;
  values.columns = columns;
  return values;
}

export async function load() {
  const data = JSON.parse(document.getElementById("data").textContent), bytes = await inflate("blob");
  const arrays = (value) => {
    if (Array.isArray(value)) return value.map(arrays);
    if (value === null || typeof value !== "object") return value;
    if ("orders" in value) return unpacked(bytes, value);
    return Object.fromEntries(Object.entries(value).map(([key, x]) => [key, arrays(x)]));
  };
  const found = arrays(data);
  for (const { curves } of found.histories) for (const { y, gaps } of curves) for (const i of gaps ?? []) y[i] = NaN;
  return found;
}
