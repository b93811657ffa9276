// The picture: bands on a canvas, and the curves over them, which alone change during a drag.
const SVG = "http://www.w3.org/2000/svg";

function element(name, attributes = {}, text = "") {
  const it = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) it.setAttribute(key, value);
  it.textContent = text;
  return it;
}

// A step of 1, 2 or 5 times a power of ten, at most six of them in `width`.
function niceStep(width) {
  const power = 10 ** Math.floor(Math.log10(width / 6));
  return power * [1, 2, 5, 10].find((m) => 6 * m * power >= width);
}

class Picture {
  constructor(plot) {
    this.plot = plot;
    this.canvas = plot.querySelector("canvas");
    this.svg = plot.querySelector("svg");
    this.axes = element("g");
    // An element of its own hides what is outside of it.
    this.curves = element("svg", { class: "curves", width: "100%", height: "100%" });
    this.svg.append(this.axes, this.curves);
    this.background = { bands: [], undefined: "" };
    new ResizeObserver(() => this.resize()).observe(plot);
  }

  // Shows the square with this centre and half side.
  show({ centre, half }) {
    this.left = centre[0] - half;
    this.top = centre[1] + half;
    this.side = 2 * half;
    this.resize();
  }

  get view() {
    return [this.left, this.left + this.side, this.top - this.side, this.top];
  }

  // From the plane to pixels of the plot, and back.
  place([x, y]) {
    const scale = this.size / this.side;
    return [(x - this.left) * scale, (this.top - y) * scale];
  }

  point(across, down) {
    const scale = this.side / this.size;
    return [this.left + across * scale, this.top - down * scale];
  }

  resize() {
    this.size = this.plot.clientWidth;
    if (!this.side || !this.size) return;
    this.svg.setAttribute("viewBox", `0 0 ${this.size} ${this.size}`);
    this.drawAxes();
    this.drawBands();
    this.onresize?.();
  }

  drawAxes() {
    const { size, left, top, side } = this;
    const step = niceStep(side);
    const digits = Math.max(0, Math.ceil(-Math.log10(step)));
    const label = (value) => (Math.abs(value) < step / 2 ? 0 : value).toFixed(digits).replace("-", "−");
    const parts = [element("rect", { class: "frame", width: size, height: size, rx: 4 })];
    for (let k = Math.ceil(left / step); k * step <= left + side; k++) {
      const [x] = this.place([k * step, top]);
      parts.push(element("path", { class: "tick", d: `M${x} ${size}v5` }));
      parts.push(element("text", { x, y: size + 19, "text-anchor": "middle" }, label(k * step)));
    }
    for (let k = Math.ceil((top - side) / step); k * step <= top; k++) {
      const [, y] = this.place([left, k * step]);
      parts.push(element("path", { class: "tick", d: `M0 ${y}h-5` }));
      parts.push(element("text", { x: -9, y: y + 4, "text-anchor": "end" }, label(k * step)));
    }
    this.axes.replaceChildren(...parts);
  }

  drawBands() {
    const pixels = Math.round(this.size * devicePixelRatio);
    this.canvas.width = this.canvas.height = pixels;
    const context = this.canvas.getContext("2d");
    context.scale(pixels / 1000, pixels / 1000);
    context.lineWidth = 1000 / this.size;
    context.strokeStyle = "rgb(26 26 26 / 0.16)";
    for (const { colour, path } of this.background.bands) {
      const region = path ? new Path2D(path) : new Path2D("M0 0H1000V1000H0Z");
      context.fillStyle = colour;
      context.fill(region, "evenodd");
      if (path) context.stroke(region);
    }
    if (!this.background.undefined) return;
    context.save();
    const region = new Path2D(this.background.undefined);
    context.clip(region, "evenodd");
    context.fillStyle = "#fff";
    context.fillRect(0, 0, 1000, 1000);
    context.strokeStyle = "#a5a8ac";
    for (let k = 0; k <= 2000; k += 14) context.stroke(new Path2D(`M${k} 0L0 ${k}`));
    context.restore();
  }

  // Draws the other minima first, so that the curve lies over them.
  drawCurves(points, others) {
    const path = (line) => "M" + line.map((p) => this.place(p).map((c) => c.toFixed(2)).join(" ")).join("L");
    const drawn = (line, name) => {
      const group = element("g", { class: name });
      const d = path(line);
      group.append(element("path", { class: "casing", d }), element("path", { class: "line", d }));
      return group;
    };
    const all = others.map((other) => drawn(other.points, "other"));
    if (points.length) all.push(drawn(points, "found"));
    this.curves.replaceChildren(...all);
  }
}
