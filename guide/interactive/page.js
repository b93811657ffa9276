// The page: what the reader asks, and the answers in words.
const by = (id) => document.getElementById(id);
const number = (value, digits) => value.toFixed(digits).replace("-", "−");

// Seven significant digits.
const seven = (value) => number(value, Math.min(12, Math.max(0, 6 - Math.floor(Math.log10(value || 1)))));

// Bounds rounded outward, with two digits of their distance.
function bounds(lower, upper) {
  const digits = Math.min(9, Math.max(2, 1 - Math.floor(Math.log10(upper - lower || 1e-9))));
  // The product is off by half a unit of its last place, which must not reach the next whole number.
  const [low, high] = [lower * (1 - 2 ** -51), upper * (1 + 2 ** -51)];
  const [down, up] = [Math.floor(low * 10 ** digits), Math.ceil(high * 10 ** digits)];
  return [down, up].map((value) => number(value / 10 ** digits, digits));
}

class Page {
  constructor(solver, prover) {
    this.solver = solver;
    this.prover = prover;
    this.picture = new Picture(by("plot"));
    this.picture.onresize = () => this.draw();
    this.curve = { points: [], others: [], doubts: [] };
    for (const { name } of EXAMPLES) by("example").append(new Option(name));
    by("example").append(new Option("Your own", "own"));
    by("example").oninput = () => this.choose(EXAMPLES[by("example").selectedIndex]);
    by("formula").oninput = () => this.type();
    by("chords").oninput = () => this.ask();
    by("nearer").onclick = () => this.zoom(1 / 1.5);
    by("farther").onclick = () => this.zoom(1.5);
    for (const end of ["from", "to"]) this.listen(end);
    this.choose(EXAMPLES[0]);
  }

  choose(example) {
    if (!example) return by("formula").focus();
    const { formula, about, from, to, centre, half } = example;
    by("formula").value = formula;
    by("about").textContent = about;
    Object.assign(this, { formula, from: [...from], to: [...to], centre, half });
    this.picture.show(this);
    this.paint();
    this.ask();
  }

  type() {
    by("example").value = "own";
    by("about").textContent = "";
    this.formula = by("formula").value;
    this.ask();
    clearTimeout(this.painting);
    this.painting = setTimeout(() => this.paint(), 150);
  }

  zoom(factor) {
    this.half *= factor;
    this.picture.show(this);
    this.paint();
  }

  // An end follows the pointer, the arrow keys and its two number boxes.
  listen(end) {
    const handle = by(end);
    const move = (event) => {
      const box = by("plot").getBoundingClientRect();
      this.move(end, this.picture.point(event.clientX - box.left, event.clientY - box.top));
    };
    handle.onpointerdown = (event) => {
      if (event.button !== 0) return;
      handle.setPointerCapture(event.pointerId);
      handle.focus({ focusVisible: false });
      event.preventDefault();
    };
    handle.onpointermove = (event) => {
      if (handle.hasPointerCapture(event.pointerId)) move(event);
    };
    handle.onkeydown = (event) => {
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (!way || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      const step = this.half / (event.shiftKey ? 8 : 80);
      this.move(end, this[end].map((value, i) => value + step * way[i]));
    };
    for (const i of [0, 1]) {
      const box = by(`${end}-${i + 1}`);
      box.onchange = () => {
        if (!Number.isFinite(box.valueAsNumber)) return this.draw();
        this[end][i] = box.valueAsNumber;
        this.ask();
      };
    }
  }

  // Moves an end within the view, and asks once for all moves before the next frame. The
  // coordinates are rounded to what a reader can see, so that the page shows the very question.
  move(end, place) {
    const digits = Math.max(0, 3 - Math.floor(Math.log10(this.half)));
    const margin = 1e-3 * this.half;
    this[end] = place.map((value, i) => {
      const [least, most] = [this.centre[i] - this.half + margin, this.centre[i] + this.half - margin];
      return Number(Math.min(most, Math.max(least, value)).toFixed(digits));
    });
    this.frame ??= requestAnimationFrame(() => {
      this.frame = null;
      this.ask();
    });
  }

  get question() {
    return [this.formula, ...this.from, ...this.to, Number(by("chords").value)];
  }

  ask() {
    const start = performance.now();
    const { Ok, Err } = JSON.parse(this.solver.solve(...this.question));
    const took = performance.now() - start;
    this.complain(Err);
    by("plot").classList.toggle("stale", Boolean(Err));
    this.prover.withdraw();
    clearTimeout(this.proving);
    if (Ok) {
      this.curve = Ok;
      by("length").textContent = seven(Ok.length);
      by("time").textContent = `solved in ${took.toFixed(1)} ms`;
      this.list(Ok.others);
      by("bound").textContent = "…";
      this.say("");
      this.proving = setTimeout(() => this.prove(), 200);
    } else {
      for (const id of ["length", "bound", "others"]) by(id).textContent = "–";
      by("time").textContent = by("status").textContent = "";
    }
    this.draw();
  }

  // Says something of the bounds, after the doubts about the curve.
  say(words) {
    const sentence = (text) => `${text[0].toUpperCase()}${text.slice(1)}.`;
    by("status").textContent = [...this.curve.doubts.map(sentence), words].join(" ");
  }

  prove() {
    this.say("Proving …");
    this.prover.ask(this.question, ({ Ok, Err }) => {
      const { lower, upper, assumes_global_minimum: assumes, reason } = Ok ?? { reason: Err.message };
      if (lower != null) {
        const [from, to] = bounds(lower, upper);
        by("bound").innerHTML = `${from} ≤ <var>d</var> ≤ ${to}`;
        this.say(assumes
          ? `The upper bound is certain. The lower one assumes that no other curve of ${this.curve.points.length - 1} chords is shorter.`
          : "Both bounds are proved, with no assumption.");
      } else {
        by("bound").innerHTML = upper == null ? "–" : `<var>d</var> ≤ ${bounds(0.99999 * upper, upper)[1]}`;
        // Four digits are enough in a sentence.
        const four = (digits) => Number(Number(digits).toPrecision(4));
        this.say(`No lower bound: ${reason.replace(/\d+\.\d{4,}/g, four)}.`);
      }
    });
  }

  complain(complaint) {
    by("formula").setAttribute("aria-invalid", Boolean(complaint));
    by("complaint").replaceChildren();
    if (!complaint) return;
    const words = document.createElement("p");
    const { message, start, end, help } = complaint;
    const sentence = (text) => `${text[0].toUpperCase()}${text.slice(1)}${text.endsWith("?") ? "" : "."}`;
    words.textContent = [message, help].filter(Boolean).map(sentence).join(" ");
    by("complaint").append(words);
    if (start == null) return;
    const text = document.createElement("pre");
    const mark = document.createElement("mark");
    mark.textContent = this.formula.slice(start, end) || "\u00a0";
    text.append(this.formula.slice(0, start), mark, this.formula.slice(end));
    by("complaint").append(text);
  }

  list(others) {
    by("others").classList.toggle("none", others.length === 0);
    const lengths = others.map(({ length }) => seven(length)).join(", ");
    by("others").textContent = others.length === 0 ? "none found" : `${others.length === 1 ? "length" : "lengths"} ${lengths}`;
  }

  // Repaints the bands and their key.
  paint() {
    const { Ok } = JSON.parse(this.solver.background(this.formula, ...this.picture.view));
    if (!Ok) return;
    this.picture.background = Ok;
    this.picture.drawBands();
    const key = by("key");
    const piece = (tag, name, text = "") => {
      const it = document.createElement(tag);
      it.className = name;
      it.textContent = text;
      return it;
    };
    const ramp = piece("span", "ramp");
    for (const { colour } of Ok.bands) ramp.append(Object.assign(piece("i", ""), { style: `background:${colour}` }));
    const three = (value) => Number(value.toPrecision(3)).toString();
    const parts = [piece("span", "", "√det H")];
    if (Ok.least != null) parts.push(piece("span", "", three(Ok.least)), ramp, piece("span", "", three(Ok.greatest)));
    if (Ok.undefined) parts.push(piece("span", "void"), piece("span", "", "no metric"));
    key.replaceChildren(...parts);
  }

  draw() {
    this.picture.drawCurves(this.curve.points, this.curve.others);
    for (const end of ["from", "to"]) {
      const [x, y] = this.picture.place(this[end]);
      const handle = by(end);
      handle.style.transform = `translate(${x}px, ${y}px)`;
      const isInside = [x, y].every((place) => place >= 0 && place <= this.picture.size);
      handle.style.visibility = isInside ? "" : "hidden";
      const [first, second] = this[end];
      handle.setAttribute("aria-valuemin", this.picture.view[0]);
      handle.setAttribute("aria-valuemax", this.picture.view[1]);
      handle.setAttribute("aria-valuenow", first);
      handle.setAttribute("aria-valuetext", `${first}, ${second}; length ${by("length").textContent}`);
      by(`${end}-1`).value = first;
      by(`${end}-2`).value = second;
    }
  }
}

function fail(words) {
  by("failure").textContent = words;
  by("failure").hidden = false;
}

async function load() {
  const packed = Uint8Array.from(atob(by("program").textContent), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const module = await WebAssembly.compile(await new Response(stream).arrayBuffer());
  wasm_bindgen.initSync({ module });
  return module;
}

load()
  .then((module) => {
    window.page = new Page(wasm_bindgen, new Prover(module));
  })
  .catch((error) => fail(`This page needs a browser of 2023 or newer. ${error}`));

// After a fault of the solver its memory is in an unknown state.
addEventListener("error", ({ message }) => fail(`The page failed and has to be loaded again. ${message}`));
