// Histories in step with the time: one group of one unit at a time, with a cursor and marks of events.

import { palette } from "./geometry.js";

const LEFT = 56, RIGHT = 10, BOTTOM = 17, TOP = 6;
const DASHES = [[], [7, 4], [2, 3], [9, 3, 2, 3]];

function ticks(low, high, most) {
  const rough = (high - low) / most, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= rough * 0.999), found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step && found.length < 4 * most; k++) found.push(k * step);
  // as many digits as tell one from the next
  const digits = Math.min(15, Math.max(4, Math.ceil(Math.log10(Math.max(Math.abs(low), Math.abs(high)) / step)) + 1));
  return found.map((y) => [y, short(y, digits)]);
}

// few letters, also of what is very large or small
export function short(x, digits = 4) {
  const rounded = Number(x.toPrecision(digits)), size = Math.abs(rounded);
  return size && (size >= 1e6 || size < 1e-4) && digits <= 6 ? rounded.toExponential().replace("e+", "e") : String(rounded);
}

export class Strip {
  constructor(canvas, legend, tabs, data, css, go) {
    Object.assign(this, { canvas, legend, data, css, pen: canvas.getContext("2d") });
    this.t = data.t;
    [this.first, this.last] = [data.t[0], data.t[data.t.length - 1]];
    this.buttons = data.histories.map((group, k) => {
      const button = document.createElement("button");
      button.setAttribute("role", "tab");
      button.textContent = group.unit ? `${group.name} [${group.unit}]` : group.name;
      button.onclick = () => { this.choose(k); go(null); };
      tabs.append(button);
      return button;
    });
    const at = (e) => {
      const box = canvas.getBoundingClientRect(), f = (e.clientX - box.left - LEFT) / (box.width - LEFT - RIGHT);
      go(this.first + (this.last - this.first) * Math.min(1, Math.max(0, f)));
    };
    canvas.onpointerdown = (e) => { canvas.setPointerCapture(e.pointerId); canvas.onpointermove = at; at(e); };
    canvas.onpointerup = canvas.onpointercancel = () => { canvas.onpointermove = null; };
    this.choose(0);
  }

  choose(k) {
    this.group = this.data.histories[k];
    this.buttons.forEach((button, j) => button.setAttribute("aria-selected", j === k));
    this.legend.replaceChildren(...this.group.curves.map((curve, j) => {
      const entry = document.createElement("span");
      entry.style.setProperty("--c", palette[j % palette.length]);
      entry.style.setProperty("--d", DASHES[Math.floor(j / palette.length) % 4].length ? "dashed" : "solid");
      return entry;
    }));
    let [low, high] = [Infinity, -Infinity];
    for (const { y } of this.group.curves) for (const v of y) if (!Number.isNaN(v)) { low = Math.min(low, v); high = Math.max(high, v); }
    if (low > high) [low, high] = [0, 0];
    const margin = 0.06 * (high - low) || Math.abs(high) * 0.05 || 1;
    [this.low, this.high] = [low - margin, high + margin];
    this.still = null;
  }

  measure() {
    const ratio = devicePixelRatio || 1, { canvas } = this;
    canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
    canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    const [width, height] = [canvas.width / ratio, canvas.height / ratio];
    this.X = (t) => LEFT + ((width - LEFT - RIGHT) * (t - this.first)) / (this.last - this.first || 1);
    this.Y = (y) => TOP + ((height - BOTTOM - TOP) * (this.high - y)) / (this.high - this.low);
    Object.assign(this, { ratio, width, height });
  }

  // everything but the cursor, kept as a picture
  background() {
    this.measure();
    const { pen, X, Y, width, height, ratio, css } = this;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.font = "11px system-ui, sans-serif";
    pen.lineWidth = 1;
    pen.strokeStyle = css("--faint");
    pen.fillStyle = css("--soft");
    pen.textBaseline = "middle";
    pen.textAlign = "right";
    for (const [y, text] of ticks(this.low, this.high, 5)) {
      pen.beginPath(); pen.moveTo(LEFT, Y(y)); pen.lineTo(width - RIGHT, Y(y)); pen.stroke();
      pen.fillText(text, LEFT - 7, Y(y), LEFT - 8);
    }
    pen.textBaseline = "alphabetic";
    pen.textAlign = "center";
    const [from, to] = [Math.min(this.first, this.last), Math.max(this.first, this.last)];
    if (to > from) for (const [t, text] of ticks(from, to, Math.max(2, width / 95))) pen.fillText(text, Math.min(X(t), width - 1 - pen.measureText(text).width / 2), height - 3);
    pen.strokeStyle = pen.fillStyle = css("--soft");
    for (const event of this.data.events) {
      pen.beginPath(); pen.moveTo(X(event.t), TOP); pen.lineTo(X(event.t), height - BOTTOM); pen.globalAlpha = 0.25; pen.stroke(); pen.globalAlpha = 1;
      pen.beginPath(); pen.moveTo(X(event.t) - 4, 0); pen.lineTo(X(event.t) + 4, 0); pen.lineTo(X(event.t), TOP + 1); pen.fill();
    }
    pen.lineJoin = "round";
    pen.lineWidth = 1.7;
    this.group.curves.forEach(({ y }, k) => {
      pen.strokeStyle = palette[k % palette.length];
      pen.setLineDash(DASHES[Math.floor(k / palette.length) % 4]);
      pen.beginPath();
      for (let i = 0; i < this.t.length; i++) if (!Number.isNaN(y[i])) pen[i && !Number.isNaN(y[i - 1]) ? "lineTo" : "moveTo"](X(this.t[i]), Y(y[i]));
      pen.stroke();
    });
    pen.setLineDash([]);
    this.still = document.createElement("canvas");
    [this.still.width, this.still.height] = [this.canvas.width, this.canvas.height];
    this.still.getContext("2d").drawImage(this.canvas, 0, 0);
  }

  draw(now, i, k) {
    if (!this.canvas.clientWidth) return;
    if (!this.still) this.background();
    const { pen, X, Y, ratio, height, css } = this;
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    pen.drawImage(this.still, 0, 0);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.strokeStyle = css("--ink");
    pen.lineWidth = 1;
    pen.beginPath(); pen.moveTo(X(now), 0); pen.lineTo(X(now), height - BOTTOM); pen.stroke();
    this.group.curves.forEach(({ name, y }, j) => {
      const value = y[i] + k * (y[Math.min(i + 1, y.length - 1)] - y[i]);
      pen.fillStyle = palette[j % palette.length];
      pen.beginPath(); pen.arc(X(now), Y(value), 3.4, 0, 7); pen.fill();
      this.legend.children[j].textContent = `${name} ${short(value)}`;
    });
  }

  // the event whose mark is under a pixel
  event(x) {
    const near = this.data.events.find((e) => Math.abs(this.X(e.t) - x) < 5);
    return near && near.name;
  }
}
