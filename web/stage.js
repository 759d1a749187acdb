// SPDX-License-Identifier: Apache-2.0
// @ts-check
// The stage from elsewhere: the show's cameras as cards, or a view of one's own. A tap measures.
import {hearFingers, Painter} from "./draw.js";
import {cameraOf, dolly, orbitOf, round, slide, turn} from "./orbit.js";
import {age, hear, isCalm, isHidden, make, mayControl, now, onShown, plain, putText, smallPicture, thumbnail} from "./store.js";
import {doIt, outcome, wish} from "./wire.js";

const WHEN = "in turn";
const STILL = 16;  // flag of a picture
const MOVE_EVERY_MS = 150;
const OLD_MS = 3000;
const MEASURING = "measuring ...";
const NOT_MEASURED = "not measured: the line is lost";

class Stage extends HTMLElement {
  connectedCallback() {
    this.painter = new Painter((message) => this.tell(message));
    this.cross = make("span", {class: "cross", "aria-hidden": "true"});
    this.view = make("div", {class: "stage side", tabindex: "0", role: "button"}, this.painter.canvas, this.cross);
    this.what = make("p", {class: "grow", role: "status"});
    this.measured = make("p", {class: "measured", role: "status"});
    this.when = make("p", {class: "bad", hidden: ""});
    this.paintedMs = 0;  // 0: nothing is
    this.measures = false;
    this.own = make("button", {type: "button", "aria-pressed": "false"}, "My own view");
    this.put = make("button", {type: "button"}, "Put the picture there");
    this.cards = make("ul", {class: "cards"});
    this.frame = make("div", {class: "frame"}, this.view, make("div", {class: "under"}, this.what, this.when, this.measured, this.put));
    this.append(this.frame, make("div", {class: "tools"}, this.own), this.cards);
    this.chosen = "";  // name of a camera; empty: none
    /** @type {import("./orbit.js").Orbit | null} */
    this.orbit = null;
    /** @type {number[] | null} */
    this.probe = null;
    this.painter.canvas.setAttribute("aria-label", "The stage from elsewhere");
    /** @type {Map<string, {item: HTMLElement, button: HTMLElement, picture: HTMLElement, url: string}>} */
    this.rows = new Map();
    this.own.addEventListener("click", () => this.takeOwn());
    this.put.addEventListener("click", () => this.putPicture());
    this.hearMoves();
    hear("show", () => this.build());
    hear("hello", () => this.name());
    hear("measure", () => this.tellMeasure());
    hear("isOpen", () => this.tellLine());
    setInterval(() => this.tellAge(), 250);
    hear("refusedView", () => this.refuse());
    hear("small", () => this.paint());
    onShown(this, () => {
      this.paint();
      this.ask();
      wish({type: "pictures", on: !isHidden("looks") || !isHidden("stage")});
    });
    addEventListener("resize", () => this.ask());
    hear("calm", () => this.ask());
    this.name();
  }

  build() {
    const cameras = now.show.cameras;
    const shape = JSON.stringify(cameras);
    if (shape === this.shape) return;
    this.shape = shape;
    this.rows = new Map(cameras.map((/** @type {{name: string}} */ camera) => {
      const picture = make("div", {class: "thumb"}, thumbnail("", WHEN));
      const button = make("button", {type: "button", "aria-pressed": "false"}, picture, make("div", {class: "words"}, make("span", {class: "name"}, camera.name)));
      button.addEventListener("click", () => this.choose(camera.name));
      return [camera.name, {item: make("li", {class: "card"}, button), button, picture, url: ""}];
    }));
    this.cards.replaceChildren(...[...this.rows.values()].map((row) => row.item));
    this.chosen = "";
    this.orbit = null;
    this.name();
    this.paint();
  }

  /** @param {string} name */
  choose(name) {
    this.chosen = name;
    this.orbit = null;
    this.begin(`Camera ${name}: waiting for its picture`);
  }

  takeOwn() {
    const cameras = now.show?.cameras ?? [];
    const from = cameras.find((/** @type {{name: string}} */ camera) => camera.name === (this.chosen || now.state?.camera)) ?? cameras[0];
    const [x, y, z] = now.show?.centre_m ?? [0, 0, 2];
    const far = 2.5 * (now.show?.radius_m ?? 10);
    this.orbit = orbitOf(from ?? {position_m: [x, y - far, z + far / 4], target_m: [x, y, z], fov_y_deg: 40});
    this.chosen = "";
    this.begin("My own view: waiting for its picture");
    this.view.focus();
  }

  /** @param {string} said */
  begin(said) {
    this.forgetMeasure();
    this.what.classList.remove("bad");
    putText(this.what, said);
    this.name();
    this.ask(true);
  }

  name() {
    const has = Boolean(this.chosen || this.orbit);
    this.frame.hidden = !has;
    this.classList.toggle("open", has);  // the cards beside it, where there is room
    this.own.setAttribute("aria-pressed", String(Boolean(this.orbit)));
    for (const [name, row] of this.rows) {
      row.button.setAttribute("aria-pressed", String(name === this.chosen));
      row.item.classList.toggle("now", name === this.chosen);
    }
    this.put.hidden = !mayControl() || !this.chosen;
    this.view.setAttribute(
        "aria-label", this.orbit ? "My own view. Arrows orbit, with Shift they slide, plus and minus go near and far, Enter measures the middle" :
                                   plain(`Camera ${this.chosen}. Enter measures the middle`));
  }

  ask(isAgain = false) {
    if (this.hidden || !(this.chosen || this.orbit)) return;
    const width = Math.round(this.view.clientWidth * devicePixelRatio);
    wish({
      type: "watch",
      width: Math.min(Math.max(width, 320), 4096),
      calm: isCalm(),
      ...(this.orbit ? {own: cameraOf(this.orbit)} : {camera: this.chosen}),
      ...(this.probe ? {probe: this.probe} : {}),
    }, isAgain);
  }

  async putPicture() {
    const refused = await doIt("camera", [this.chosen, 1]);
    this.what.textContent = outcome(refused) || "The picture goes there.";
  }

  /** @param {DataView} message */
  tell(message) {
    this.paintedMs = performance.now();
    const isStill = message.getUint8(1) & STILL;
    const what = this.orbit ? "My own view" : `Camera ${this.chosen}`;
    putText(this.what, isStill ? `${what} \u00b7 a still, renewed every few seconds, and whole when the lamps rest` : what);
    this.what.classList.remove("bad");
    this.painter.canvas.setAttribute("aria-label", plain(what));
  }

  tellAge() {
    const isOld = this.paintedMs > 0 && !now.isOpen && performance.now() - this.paintedMs > OLD_MS;
    this.frame.classList.toggle("old", isOld);
    this.when.hidden = !isOld;
    if (isOld) this.when.textContent = age(this.paintedMs);
  }

  // What is asked is asked again when the line is back.
  tellLine() {
    if (this.measures) this.measured.textContent = now.isOpen ? MEASURING : NOT_MEASURED;
  }

  tellMeasure() {
    this.measures = false;
    const {lux, cd_m2, object, distance_m, place} = now.measure;
    const figure = (/** @type {number} */ value) => (value >= 100 ? Math.round(value).toString() : value.toPrecision(2));
    const parts = lux === undefined ? ["nothing is met there"] : [`${figure(lux)} lux`, `on ${object || "a surface"}`, `${distance_m.toFixed(1)} m away`];
    putText(this.measured, [`${figure(cd_m2)} cd/m\u00b2`, ...parts].join(" \u00b7 "));
    const box = this.shown();
    this.cross.hidden = false;
    this.cross.style.left = `${box.left + place[0] * box.width}px`;
    this.cross.style.top = `${box.top + place[1] * box.height}px`;
  }

  refuse() {
    putText(this.what, `Not drawn: ${now.refusedView}.`);
    this.what.classList.add("bad");
  }

  paint() {
    if (this.hidden) return;
    for (const [name, row] of this.rows) {
      const url = smallPicture("camera", name);
      if (url === row.url) continue;
      row.url = url;
      row.picture.replaceChildren(thumbnail(url, WHEN));
    }
  }

  // Where the picture lies in its element, which has another shape.
  shown() {
    const {clientWidth, clientHeight} = this.view;
    const {width, height} = this.painter.canvas;
    const scale = Math.min(clientWidth / width, clientHeight / height);
    return {left: (clientWidth - width * scale) / 2, top: (clientHeight - height * scale) / 2, width: width * scale, height: height * scale};
  }

  hearMoves() {
    hearFingers(this.view, {
      drag: (dx, dy) => this.turn((-dx / this.view.clientHeight) * 3, (dy / this.view.clientHeight) * 3),
      pinch: (factor, x, y, dx, dy) => {
        if (!this.orbit) return;
        slide(this.orbit, -dx / this.view.clientHeight, dy / this.view.clientHeight);
        this.dolly(factor);
      },
      tap: (x, y) => {
        const box = this.view.getBoundingClientRect();
        const shown = this.shown();
        this.measureAt((x - box.left - shown.left) / shown.width, (y - box.top - shown.top) / shown.height);
      },
      end: () => this.moved(true),
    });
    this.view.addEventListener("wheel", (event) => {
      if (!this.orbit) return;
      event.preventDefault();
      this.dolly(Math.exp(-event.deltaY / 400));
    }, {passive: false});
    this.view.addEventListener("keydown", (event) => this.key(event));
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
    if (event.key === "Enter" || event.key === " ") {
      this.measureAt(0.5, 0.5);
    } else if (this.orbit && event.key in steps) {
      const [x, y] = steps[event.key];
      if (event.shiftKey) {
        slide(this.orbit, x / 20, y / 20);
        this.moved();
      } else {
        this.turn(x / 12, y / 12);
      }
    } else if (event.key === "+" || event.key === "-") {
      this.dolly(event.key === "+" ? 1.15 : 1 / 1.15);
    } else {
      return;
    }
    event.preventDefault();
  }

  /** @param {number} yaw @param {number} pitch */
  turn(yaw, pitch) {
    if (!this.orbit) return;
    turn(this.orbit, yaw, pitch);
    this.moved();
  }

  /** @param {number} factor */
  dolly(factor) {
    if (!this.orbit) return;
    dolly(this.orbit, factor);
    this.moved();
  }

  /** @param {number} x @param {number} y */
  measureAt(x, y) {
    if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1)) return;
    this.probe = [round(x), round(y)];
    this.measures = true;
    this.tellLine();
    this.ask();
  }

  forgetMeasure() {
    this.probe = null;
    this.measures = false;
    this.cross.hidden = true;
    this.measured.textContent = "";
  }

  // Not with every pixel: the line has a limit, and each is another picture.
  moved(isLast = false) {
    if (!this.orbit) return;
    if (!isLast) this.forgetMeasure();
    if (this.timer) return;
    this.timer = setTimeout(() => {
      this.timer = 0;
      this.ask();
    }, isLast ? 0 : MOVE_EVERY_MS);
  }
}
customElements.define("ghost-stage", Stage);

/** @param {DataView} message */
export function takeSide(message) {
  /** @type {any} */ (document.querySelector("ghost-stage")).painter.take(message);
}
