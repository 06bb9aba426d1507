// SPDX-License-Identifier: GPL-3.0-or-later
// The viewer of the pages that `insideout draw SURFACE page.html` writes. Three panels share a camera: the surface with
// its defects; the hull's section by a plane that a slider moves, colored by w; the solid's tetrahedra behind that plane.
"use strict";

const scene = JSON.parse(document.getElementById("scene").textContent);
const byId = (id) => document.getElementById(id);

// ---- Data: bytes of columns, compressed. A row of ids begins with its least, relative to the row before; the others are relative to that.

async function unpack() {
  const text = atob(byId("data").textContent);
  const packed = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) packed[k] = text.charCodeAt(k);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const arrays = {};
  let next = 0;
  for (const { name, kind, rows, columns } of scene.arrays) {
    const size = columns * (kind === "bytes" ? 1 : 4);
    const values = new Uint8Array(rows * size);
    for (let column = 0; column < size; ++column)
      for (let k = column; k < values.length; k += size) values[k] = bytes[next++];
    arrays[name] = kind === "bytes" ? values : kind === "floats" ? new Float32Array(values.buffer) : idsOf(values, columns);
  }
  return arrays;
}

function idsOf(values, columns) {
  const ids = new Uint32Array(values.buffer);
  for (let row = 0, least = 0; row < ids.length; row += columns) {
    least = ids[row] += least;
    for (let k = 1; k < columns; ++k) ids[row + k] += least;
  }
  return ids;
}

// ---- Vectors

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const plus = (a, b, factor = 1) => a.map((x, k) => x + factor * b[k]);
const unit = (a) => a.map((x) => x / Math.hypot(...a));

function turned(v, axis, angle) {
  const along = dot(v, axis) * (1 - Math.cos(angle));
  return plus(plus(v.map((x) => x * Math.cos(angle)), cross(axis, v), Math.sin(angle)), axis, along);
}

// ---- The camera, a parallel projection. The scene is within a ball of radius 1.

const STEEPEST = 0.995; // how far the eye may rise towards the vertical, as a sine
const DEPTH = 4;
const FILLED = 0.92; // of the panel, at first

const camera = {
  reset() {
    this.eye = unit(scene.view.eye);
    this.up = unit(plus(scene.view.up, this.eye, -dot(scene.view.up, this.eye)));
    this.target = [0, 0, 0];
    this.zoom = 1;
  },
  right() {
    return cross(this.up, this.eye);
  },
  turn(across, down) {
    const rise = Math.asin(dot(this.eye, scene.view.up));
    const most = Math.asin(STEEPEST);
    const tilt = Math.min(Math.max(rise + down, -most), most) - rise;
    const right = turned(this.right(), scene.view.up, -across);
    this.eye = unit(turned(turned(this.eye, scene.view.up, -across), right, -tilt));
    this.up = unit(cross(this.eye, right));
  },
  move(across, up) {
    this.target = plus(plus(this.target, this.right(), -across), this.up, -up);
  },
  scale(width, height) { // from lengths to halves of the panel's height
    const [across, up] = scene.view.size;
    return 2 * FILLED * this.zoom * Math.min(1 / up, width / height / across);
  },
  axes() { // in rows
    return [this.right(), this.up, this.eye];
  },
  matrix(width, height) { // column by column
    const y = this.scale(width, height);
    const rows = this.axes().map((axis, k) => axis.map((x) => x * [y * height / width, y, -1 / DEPTH][k]));
    return [0, 1, 2].flatMap((k) => [...rows.map((row) => row[k]), 0]).concat(rows.map((row) => -dot(row, this.target)), 1);
  },
};

// ---- What is drawn

const HEAD = "#version 300 es\nprecision highp float;\n";

// Facets are lit flat, from the screen's derivatives; their edges fade where they would hide the facets.
const FACETS = [`${HEAD}
in vec3 place;
in vec4 color;
uniform mat4 view;
uniform mat3 axes;
out vec3 seen;
out vec3 corner;
flat out vec4 shade;
void main() {
  seen = axes * place;
  int k = gl_VertexID % 3;
  corner = vec3(k == 0, k == 1, k == 2);
  shade = color;
  gl_Position = view * vec4(place, 1.);
}`, `${HEAD}
in vec3 seen;
in vec3 corner;
flat in vec4 shade;
uniform vec4 edges;
uniform float edgeWidth;
uniform float within;
uniform bool lit;
out vec4 pixel;
const vec3 KEY = vec3(.383, .643, .663);
const vec3 FILL = vec3(0., -.966, .259);
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  normal *= normal.z < 0. ? -1. : 1.;
  float light = .32 + .7 * (.9 * max(dot(normal, KEY), 0.) + .3 * max(dot(normal, FILL), 0.) + .3 * normal.z);
  vec3 color = shade.rgb * (lit ? light : 1.) * (gl_FrontFacing || shade.a == 0. ? 1. : within);
  vec3 step = fwidth(corner);
  vec3 away = smoothstep(step * (edgeWidth - 1.), step * edgeWidth, corner);
  float edge = 1. - min(away.x, min(away.y, away.z));
  float size = 1. / max(step.x, max(step.y, step.z)); // the facet's least height in pixels
  pixel = vec4(mix(color, edges.rgb, edge * (edgeWidth > 0. ? smoothstep(2., 14., size) : 0.)), 1.);
}`];

const LINES = [`${HEAD}
in vec3 from;
in vec3 to;
in vec4 color;
uniform mat4 view;
uniform vec2 pixels;
uniform float width;
uniform float nearer;
out vec3 shade;
void main() {
  vec4 ends[2] = vec4[2](view * vec4(from, 1.), view * vec4(to, 1.));
  vec2 along = (ends[1].xy - ends[0].xy) * pixels;
  along = length(along) > 1e-6 ? normalize(along) : vec2(1., 0.);
  int end = gl_VertexID / 2;
  float side = gl_VertexID % 2 == 0 ? 1. : -1.;
  gl_Position = ends[end];
  gl_Position.xy += (side * vec2(-along.y, along.x) + (end == 0 ? -.5 : .5) * along) * width / pixels;
  gl_Position.z -= nearer;
  shade = color.rgb;
}`, `${HEAD}
in vec3 shade;
uniform float opacity;
out vec4 pixel;
void main() { pixel = vec4(shade, opacity); }`];

const BEHIND = 0.3; // how much is seen of lines behind facets

function linked(gl, sources) {
  const program = gl.createProgram();
  [gl.VERTEX_SHADER, gl.FRAGMENT_SHADER].forEach((kind, k) => {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, sources[k]);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  });
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  return program;
}

class Panel {
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl2", { alpha: false });
    if (!this.gl) throw new Error("This browser has no WebGL 2, by which pages draw.");
    this.facets = linked(this.gl, FACETS);
    this.lines = linked(this.gl, LINES);
    this.shown = new Map();
    canvas.addEventListener("webglcontextlost", () => say("The browser gave the drawing up: load the page again."));
    listen(canvas);
  }

  // Show triangles, by the places of their corners and a color each, or one for all, in place of those of the same name.
  show(name, places, colors, look) {
    this.begin(name, this.facets, places.length / 3, colors, 0, look);
    this.attribute("place", places, 3);
  }

  // The same of segments, by the places of their ends.
  showLines(name, places, colors, look) {
    this.begin(name, this.lines, places.length / 6, colors, 4, look);
    this.attribute("from", places, 3, 24);
    this.attribute("to", places, 3, 24, 12);
  }

  begin(name, program, count, colors, step, look) {
    const old = this.shown.get(name);
    old?.buffers.forEach((buffer) => this.gl.deleteBuffer(buffer));
    this.latest = { program, count, buffers: [], array: old ? old.array : this.gl.createVertexArray(), ...look };
    this.shown.set(name, this.latest);
    this.gl.bindVertexArray(this.latest.array);
    if (colors instanceof Uint8Array) this.attribute("color", colors, 4, step);
    else this.latest.color = colors.map((byte) => byte / 255);
  }

  // Lines have a step in bytes from one to the next: they are instances.
  attribute(name, values, size, step = 0, offset = 0) {
    const gl = this.gl;
    const at = gl.getAttribLocation(this.latest.program, name);
    const real = values instanceof Float32Array;
    const buffer = gl.createBuffer();
    this.latest.buffers.push(buffer);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, real ? gl.FLOAT : gl.UNSIGNED_BYTE, !real, step, offset);
    gl.vertexAttribDivisor(at, step ? 1 : 0);
  }

  draw() {
    const { gl, canvas } = this;
    const ratio = window.devicePixelRatio || 1;
    const width = Math.round(canvas.clientWidth * ratio);
    const height = Math.round(canvas.clientHeight * ratio);
    if (width * height === 0) return; // another panel has all the room
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    gl.viewport(0, 0, width, height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const able of [gl.DEPTH_TEST, gl.BLEND, gl.POLYGON_OFFSET_FILL]) gl.enable(able);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.polygonOffset(1, 1);
    const view = camera.matrix(width, height);
    for (const shown of this.shown.values()) {
      const set = (name, kind, ...values) => gl["uniform" + kind](gl.getUniformLocation(shown.program, name), ...values);
      gl.useProgram(shown.program);
      gl.bindVertexArray(shown.array);
      if (shown.color) gl.vertexAttrib4fv(gl.getAttribLocation(shown.program, "color"), shown.color);
      set("view", "Matrix4fv", false, view);
      if (shown.program === this.facets) {
        set("axes", "Matrix3fv", true, camera.axes().flat());
        set("edges", "4fv", (shown.edges || [0, 0, 0, 0]).map((byte) => byte / 255));
        set("edgeWidth", "1f", shown.edges ? 1.3 * ratio : 0);
        set("within", "1f", scene.colors.within);
        set("lit", "1i", shown.lit ? 1 : 0);
        gl.drawArrays(gl.TRIANGLES, 0, shown.count);
      } else {
        set("pixels", "2f", width, height);
        set("nearer", "1f", 0.004 / camera.zoom);
        for (const [opacity, share] of shown.through ? [[1, 1], [BEHIND, 0.5]] : [[1, 1]]) {
          set("width", "1f", shown.width * ratio * share);
          set("opacity", "1f", opacity);
          gl.depthFunc(opacity === 1 ? gl.LESS : gl.ALWAYS);
          gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, shown.count);
        }
        gl.depthFunc(gl.LESS);
      }
    }
  }
}

// ---- Triangles and segments of meshes

// Places and colors of which it is not known before how many there will be.
class Growing {
  constructor() {
    this.places = new Float32Array(1 << 16);
    this.colors = new Uint8Array(1 << 16);
    this.count = 0;
  }

  add(x, y, z, color) {
    if (3 * this.count + 3 > this.places.length || 4 * this.count + 4 > this.colors.length) this.grow();
    this.places[3 * this.count] = x;
    this.places[3 * this.count + 1] = y;
    this.places[3 * this.count + 2] = z;
    this.colors.set(color, 4 * this.count++);
  }

  grow() {
    const places = new Float32Array(2 * this.places.length);
    const colors = new Uint8Array(2 * this.colors.length);
    places.set(this.places);
    colors.set(this.colors);
    Object.assign(this, { places, colors });
  }

  end() {
    return [this.places.subarray(0, 3 * this.count), this.colors.subarray(0, 4 * this.count)];
  }
}

// The points that ids name.
function placesOf(points, ids) {
  const places = new Float32Array(3 * ids.length);
  for (let k = 0; k < places.length; ++k) places[k] = points[3 * ids[Math.floor(k / 3)] + k % 3];
  return places;
}

// The color of each kind, as many times as it has corners.
function colorsOf(kinds, corners, palette) {
  const colors = new Uint8Array(4 * corners * kinds.length);
  for (let k = 0; k < corners * kinds.length; ++k) colors.set(palette[kinds[Math.floor(k / corners)]], 4 * k);
  return colors;
}

// How far points are before a plane across an axis, as seen from the side that is cut away.
function depths(points, { axis, side, offset }) {
  const found = new Float32Array(points.length / 3);
  for (let k = 0; k < found.length; ++k) found[k] = side * (points[3 * k + axis] - offset);
  return found;
}

// The place where an edge crosses the plane.
function addCrossing(out, points, depth, from, to, color) {
  const share = depth[from] / (depth[from] - depth[to]);
  const at = (axis) => points[3 * from + axis] + share * (points[3 * to + axis] - points[3 * from + axis]);
  out.add(at(0), at(1), at(2), color);
}

// The section of cells of two dimensions or three: segments, or triangles.
function section(points, cells, size, plane, colorOf) {
  const depth = depths(points, plane);
  const out = new Growing();
  for (let begin = 0; begin < cells.length; begin += size) {
    let count = 0;
    for (let k = begin; k < begin + size; ++k) count += depth[cells[k]] < 0;
    if (count === 0 || count === size) continue;
    const cell = [...cells.subarray(begin, begin + size)];
    const before = cell.filter((point) => depth[point] >= 0);
    const edges = cell.filter((point) => depth[point] < 0).flatMap((point) => before.map((other) => [point, other]));
    for (const k of edges.length === 4 ? [0, 1, 3, 0, 3, 2] : edges.keys()) addCrossing(out, points, depth, ...edges[k], colorOf(begin / size));
  }
  return out.end();
}

const FACES = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]; // each opposite to a corner

// The faces that are seen of the cells that reach behind a plane: those on the boundary, and all of cells that it cuts.
function cutOpen({ points, cells, outer }, plane) {
  const depth = depths(points, plane);
  const out = new Growing();
  for (let cell = 0; cell < outer.length; ++cell) {
    let behind = 0;
    for (let k = 0; k < 4; ++k) behind += depth[cells[4 * cell + k]] < 0;
    if (behind === 0) continue;
    for (let face = 0; face < 4; ++face) {
      if (behind === 4 && !(outer[cell] & (1 << face))) continue;
      for (const k of FACES[face]) {
        const point = 3 * cells[4 * cell + k];
        out.add(points[point], points[point + 1], points[point + 2], scene.colors.solid);
      }
    }
  }
  return out.end()[0];
}

// ---- The page

let panels = [];
let waiting = false;

function drawSoon() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => {
    waiting = false;
    for (const panel of panels) panel.draw();
  });
}

function say(text) {
  byId("message").textContent = text;
}

// Turn, move and zoom: with one pointer, with shift or another button, with the wheel or two fingers, and by keys.
function listen(canvas) {
  const pointers = new Map();
  const move = (across, down) => {
    const length = 2 / camera.scale(canvas.clientWidth, canvas.clientHeight) / canvas.clientHeight;
    camera.move(across * length, -down * length);
  };
  const drag = (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const [across, down] = [event.clientX - last.clientX, event.clientY - last.clientY];
    const other = [...pointers.values()].find((one) => one.pointerId !== event.pointerId);
    if (other) {
      const apart = (one) => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY) || 1;
      camera.zoom *= apart(event) / apart(last);
      move(across / 2, down / 2);
    } else if (event.shiftKey || event.buttons > 1) move(across, down);
    else camera.turn(across * Math.PI / canvas.clientWidth, down * Math.PI / canvas.clientHeight);
    pointers.set(event.pointerId, event);
    drawSoon();
  };
  const zoom = (factor, x, y) => { // what is at x, y stays there
    move(-x, -y);
    camera.zoom *= factor;
    move(x, y);
    drawSoon();
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
  });
  canvas.addEventListener("pointermove", drag);
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("dblclick", reset);
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.pow(1.0015, -event.deltaY), event.offsetX - canvas.clientWidth / 2, event.offsetY - canvas.clientHeight / 2);
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    const turn = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
    const factor = { "+": 1.2, "-": 1 / 1.2 }[event.key];
    if (turn) camera.turn(...turn);
    if (factor) camera.zoom *= factor;
    if (turn || factor) event.preventDefault();
    drawSoon();
  });
}

function reset() {
  camera.reset();
  drawSoon();
}

function lookAt(place) {
  camera.target = place;
  camera.zoom = Math.max(camera.zoom, 5);
  drawSoon();
  byId("surface").scrollIntoView({ block: "nearest" });
}

// The plane of the section, by the controls: the half that the first view sees is cut away, or the other one.
function planeOf() {
  const axis = Number(document.querySelector("[name=axis]:checked").value);
  const offset = Number(byId("position").value) * scene.extent[axis];
  const seen = scene.view.eye[axis] < 0 ? -1 : 1;
  return { axis, side: byId("other").checked ? -seen : seen, offset };
}

function showCut(arrays, [, slice, solid]) {
  const { colors } = scene;
  const plane = planeOf();
  const hull = section(arrays.points, arrays.cells, 4, plane, (cell) => colors.w[arrays.w[cell]]);
  slice.show("section", ...hull, { lit: false });
  const outline = section(arrays.surfacePoints, arrays.surface, 3, plane, () => colors.ink);
  slice.showLines("outline", ...outline, { width: 1.5 });
  const points = arrays.solidPoints || arrays.points;
  const cells = arrays.solid || arrays.cells.subarray(0, 4 * arrays.outer.length);
  solid.show("solid", cutOpen({ points, cells, outer: arrays.outer }, plane), colors.solid, { lit: true, edges: colors.edges });
  const place = scene.center[plane.axis] + scene.radius * plane.offset;
  byId("place").textContent = `${"xyz"[plane.axis]} = ${Number(place.toPrecision(4))}`;
  drawSoon();
}

async function main() {
  const { colors } = scene;
  const arrays = await unpack();
  camera.reset();
  panels = [...document.querySelectorAll("canvas")].map((canvas) => new Panel(canvas));
  const [surface] = panels;
  const facets = placesOf(arrays.surfacePoints, arrays.surface);
  surface.show("facets", facets, colorsOf(arrays.kinds, 3, colors.facets), { lit: true, edges: colors.facetEdges });
  surface.showLines("defects", arrays.lines, colorsOf(arrays.lineKinds, 1, colors.lines), { width: scene.lineWidth, through: true });
  if (panels.length > 1) {
    const cut = () => showCut(arrays, panels);
    byId("cut").addEventListener("input", cut);
    cut();
  }
  byId("reset").addEventListener("click", reset);
  for (const button of document.querySelectorAll("[data-place]"))
    button.addEventListener("click", () => lookAt(JSON.parse(button.dataset.place)));
  for (const button of document.querySelectorAll(".enlarge"))
    button.addEventListener("click", () => {
      const alone = button.closest("figure").classList.toggle("alone");
      byId("panels").classList.toggle("one", alone);
    });
  new ResizeObserver(drawSoon).observe(byId("panels"));
  for (const panel of panels) panel.draw();
  document.body.dataset.drawn = Math.round(performance.now());
}

main().catch((error) => {
  say(error.message);
  console.error(error);
});
