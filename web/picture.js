// SPDX-License-Identifier: Apache-2.0
// @ts-check
// The picture as it is drawn now: pinch or Ctrl and the wheel enlarge it, a tap leaves it alone on the
// screen.
import {hearFingers, Painter} from "./draw.js";
import {age, clock, hear, isCalm, isHidden, make, now, onShown, plain, putText, setCalm} from "./store.js";
import {ageMs, wish} from "./wire.js";

const OLD_MS = 3000;
const MOST = 8;  // times enlarged

let newest = {number: 0, flags: 0, paintedMs: 0, latencyMs: NaN};
const painter = new Painter((message) => {
  newest = {
    number: message.getUint32(4, true),
    flags: message.getUint8(1),
    paintedMs: performance.now(),
    latencyMs: ageMs(message.getFloat64(8, true)) + message.getFloat32(16, true),
  };
  if (Number.isFinite(newest.latencyMs)) now.latencyMs = newest.latencyMs;
});
const {canvas} = painter;

/** @param {DataView} message */
export function takePicture(message) {
  painter.take(message);
}

class Picture extends HTMLElement {
  connectedCallback() {
    this.stage = make(
        "div", {class: "stage", tabindex: "0", role: "button", "aria-label": "The picture. Enter: alone on the screen, or with all else"},
        canvas);
    this.facts = make("p", {class: "grow"});
    this.when = make("p", {class: "quiet"});
    this.calm = make("button", {type: "button", "aria-pressed": "false", title: "Two pictures a second, against strobes"}, "Calm");
    this.append(this.stage, make("div", {class: "under"}, this.facts, this.when, this.calm));
    this.calm.addEventListener("click", () => setCalm(!isCalm()));
    hear("calm", () => this.ask());
    this.scale = 1;
    this.x = this.y = 0;
    hearFingers(this.stage, {
      drag: (dx, dy) => this.place(this.x + dx, this.y + dy),
      pinch: (factor, x, y) => this.zoom(factor, x, y),
      tap: () => this.alone(),
      end: () => this.ask(),
    });
    this.stage.addEventListener("wheel", (event) => this.wheel(event), {passive: false});
    this.stage.addEventListener("keydown", (event) => this.key(event));
    addEventListener("resize", () => this.ask());
    onShown(this, () => this.ask());
    hear("state", () => this.tell());
    setInterval(() => this.tellAge(), 250);
    this.ask();
  }

  ask() {
    this.calm.setAttribute("aria-pressed", String(isCalm()));
    if (!isHidden("stage")) return;  // which watches something else
    if (this.stage.clientWidth > 0) this.width = this.stage.clientWidth;
    const width = Math.round((this.width ?? 320) * devicePixelRatio * Math.min(this.scale, 2));
    wish({type: "watch", width: Math.min(Math.max(width, 320), 4096), calm: isCalm()});
  }

  tell() {
    const {camera, cue, source, at_s, recording_s, timecode, shining, lamps} = now.state;
    const parts = camera === undefined ? [] : [camera || "free camera"];
    if (cue) parts.push(`cue ${cue}`);
    if (now.looks?.current) parts.push(`look ${now.looks.current}`);
    if (source === "desk") parts.push("from the desk");
    if (source === "recording") parts.push(`recording ${clock(at_s)} of ${clock(recording_s)}`);
    if (source === "none") parts.push("no levels");
    if (timecode) parts.push(timecode);
    if (lamps !== undefined) parts.push(`${shining} of ${lamps} lamps shine`);
    putText(this.facts, parts.join(" \u00b7 "));
    canvas.setAttribute("aria-label", plain(`Picture: ${parts.join(", ")}`));
  }

  tellAge() {
    const sinceMs = performance.now() - newest.paintedMs;
    const isOld = newest.number > 0 && !now.isOpen && sinceMs > OLD_MS;
    this.classList.toggle("old", isOld);
    if (newest.number === 0)
      this.when.textContent = now.show ? "no picture yet" : "the show is being opened";
    else if (isOld)
      this.when.textContent = age(newest.paintedMs);
    else if (newest.flags & 4)
      this.when.textContent = "at rest";
    else if (Number.isFinite(newest.latencyMs))
      this.when.textContent = `${Math.round(newest.latencyMs)} ms after the desk`;
    else
      this.when.textContent = newest.flags & 1 ? "coarse while it moves" : "live";
  }

  // Enlarging. One finger moves what is enlarged, two pinch; a tap that does not move hides all else.

  /** @param {WheelEvent} event */
  wheel(event) {
    event.preventDefault();
    this.zoom(Math.exp(-event.deltaY / 400), event.clientX, event.clientY);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const box = this.stage.getBoundingClientRect();
    const steps = {ArrowLeft: [60, 0], ArrowRight: [-60, 0], ArrowUp: [0, 60], ArrowDown: [0, -60]};
    if (event.key === "Enter" || event.key === " ")
      this.alone();
    else if (event.key === "Escape")
      document.body.classList.remove("alone");
    else if (event.key === "+")
      this.zoom(1.25, box.left + box.width / 2, box.top + box.height / 2);
    else if (event.key === "-")
      this.zoom(0.8, box.left + box.width / 2, box.top + box.height / 2);
    else if (event.key === "0")
      this.zoom(0, 0, 0);
    else if (event.key in steps)
      this.place(this.x + steps[event.key][0], this.y + steps[event.key][1]);
    else
      return;
    event.preventDefault();
  }

  alone() {
    document.body.classList.toggle("alone");
    this.zoom(0, 0, 0);
  }

  /** @param {number} factor @param {number} clientX @param {number} clientY */
  zoom(factor, clientX, clientY) {
    const box = this.stage.getBoundingClientRect();
    const scale = Math.min(Math.max(this.scale * factor, 1), MOST);
    const share = scale / this.scale;
    const x = clientX - box.left, y = clientY - box.top;
    this.scale = scale;
    this.place(x + (this.x - x) * share, y + (this.y - y) * share);
  }

  /** @param {number} x @param {number} y */
  place(x, y) {
    const least = (/** @type {number} */ side) => side * (1 - this.scale);
    this.x = Math.min(Math.max(x, least(this.stage.clientWidth)), 0);
    this.y = Math.min(Math.max(y, least(this.stage.clientHeight)), 0);
    canvas.style.transform = `translate(${this.x}px, ${this.y}px) scale(${this.scale})`;
  }
}
customElements.define("ghost-picture", Picture);
