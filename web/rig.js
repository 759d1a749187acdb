// SPDX-License-Identifier: Apache-2.0
// @ts-check
// All lamps in rows: what each does in words, and, on a tap, why.
import {age, hear, isCalm, make, now, putText} from "./store.js";
import {heardAtMs, say, wish} from "./wire.js";

const HEAD = 16, EACH = 8;  // bytes of a message of levels, of one fixture in it
const SHINES_CD = 1;
const ASK_AGAIN_MS = 1000;
const CALM_MS = 500;
const OLD_MS = 3000;
const MANY = 500;  // rows; with fewer all are laid out: WebKitGTK leaves rows empty that it skipped once

class Rig extends HTMLElement {
  connectedCallback() {
    this.search = /** @type {HTMLInputElement} */ (
        make("input", {type: "search", placeholder: "Search lamps", "aria-label": "Search lamps by name, type or address"}));
    this.count = make("p", {class: "count", role: "status"});
    this.when = make("p", {class: "bad", hidden: ""});
    this.list = make("ul", {class: "lamps"});
    this.append(this.search, this.count, this.when, this.list);
    this.toldMs = -Infinity;
    this.later = 0;
    this.rows = [];
    this.open = -1;  // fixture that is explained
    this.said = "";  // of its way
    // What is read stays where it is while it changes; only the sentence is spoken.
    this.verdict = make("p", {"aria-live": "polite"});
    this.way = make("pre", {tabindex: "0", "aria-label": "From packet to surface", hidden: ""});
    this.why = make("div", {class: "why"}, this.verdict, this.way);
    this.search.addEventListener("input", () => this.sift());
    hear("show", () => this.build());
    hear("levels", () => this.tell());
    hear("explained", () => this.explain());
    hear("isOpen", () => this.ask());
    new MutationObserver(() => this.wants()).observe(this, {attributes: true, attributeFilter: ["hidden"]});
    this.wants();
    setInterval(() => this.ask(), ASK_AGAIN_MS);
    setInterval(() => this.tellAge(), 250);
  }

  wants() {
    wish({type: "levels", on: !this.hidden});
  }

  build() {
    this.open = -1;
    this.rows = now.show.fixtures.map(
        (/** @type {{name: string, type: string, patch: string, unsaid: string[]}} */ fixture,
         /** @type {number} */ index) => {
          const dot = make("span", {class: "dot", "aria-hidden": "true"});
          const does = make("span", {class: "does"}, patchless(fixture));
          const unsaid = fixture.unsaid.map((what) => `${what} not known`);
          const type =
              [fixture.type || "its file cannot be read", fixture.patch, ...unsaid].filter(Boolean).join(" \u00b7 ");
          const button = make(
              "button", {type: "button", "aria-expanded": "false"}, dot, make("span", {class: "name"}, fixture.name), does,
              make("span", {class: "type"}, type));
          button.addEventListener("click", () => this.toggle(index));
          return {
            item: make("li", {}, button),
            button,
            dot,
            does,
            fixture,
            words: `${fixture.name} ${type}`.toLowerCase(),
            said: "",
            colour: ""
          };
        });
    this.list.classList.toggle("many", this.rows.length > MANY);
    this.list.replaceChildren(...this.rows.map((row) => row.item));
    this.sift();
  }

  sift() {
    const wanted = this.search.value.trim().toLowerCase();
    let shown = 0;
    for (const row of this.rows) {
      row.item.hidden = !row.words.includes(wanted);
      if (!row.item.hidden) ++shown;
    }
    this.count.textContent = shown === this.rows.length ? `${shown} lamps` : `${shown} of ${this.rows.length} lamps`;
  }

  // As old as the last word of the server: levels at rest are not told again.
  tellAge() {
    const isOld = !now.isOpen && this.rows.length > 0 && performance.now() - heardAtMs() > OLD_MS;
    this.classList.toggle("old", isOld);
    this.when.hidden = !isOld;
    if (isOld) this.when.textContent = age(heardAtMs());
  }

  tell() {
    const earlyMs = isCalm() ? this.toldMs + CALM_MS - performance.now() : 0;
    if (earlyMs > 0) {
      this.later ||= setTimeout(() => {
        this.later = 0;
        this.tell();
      }, earlyMs);
      return;
    }
    const levels = now.levels;
    if (!levels || this.hidden || levels.version !== now.show?.version || levels.count !== this.rows.length) return;
    this.toldMs = performance.now();
    this.rows.forEach((row, index) => {
      const at = HEAD + EACH * index;
      const candela = levels.bytes.getFloat32(at, true);
      const [red, green, blue, dimmer] = [4, 5, 6, 7].map((k) => levels.bytes.getUint8(at + k));
      const isLit = candela >= SHINES_CD;
      const said = patchless(row.fixture) || (isLit ? `lit, ${percent(dimmer)}` : "dark");
      const colour = isLit ? `rgb(${display(red)} ${display(green)} ${display(blue)})` : "transparent";
      if (said !== row.said) row.does.textContent = row.said = said;
      if (colour !== row.colour) row.dot.style.background = row.colour = colour;
    });
  }

  /** @param {number} index */
  toggle(index) {
    const before = this.rows[this.open];
    before?.button.setAttribute("aria-expanded", "false");
    this.why.remove();
    this.open = this.open === index ? -1 : index;
    if (this.open < 0) return;
    const row = this.rows[index];
    row.button.setAttribute("aria-expanded", "true");
    this.verdict.textContent = "asking ...";
    this.said = "";
    this.way.hidden = true;
    row.item.append(this.why);
    this.ask();
  }

  ask() {
    if (this.open >= 0 && !this.hidden) say({type: "explain", fixture: this.open});
  }

  explain() {
    const {fixture, verdict, words} = now.explained;
    if (fixture !== this.open) return;
    const sentence = verdict.charAt(0).toUpperCase() + verdict.slice(1);
    const lines = words.split("\n").slice(1).join("\n").trimEnd();  // the first one is the sentence
    putText(this.verdict, sentence);
    if (this.said !== lines) this.way.replaceChildren(...lines.split("\n").map((line) => make("span", {}, line)));
    this.said = lines;
    this.way.hidden = lines === "";
  }
}
customElements.define("ghost-rig", Rig);

/** What is said where light would be. @param {{patch: string, unsaid: string[]}} fixture */
function patchless(fixture) {
  if (fixture.patch) return "";
  return fixture.unsaid.includes("address") ? "keeps its defaults" : "not patched";
}

/** Of what is lit. @param {number} dimmer a byte */
function percent(dimmer) {
  const whole = Math.round((100 * dimmer) / 255);
  return whole > 0 ? `${whole} %` : "below 1 %";
}

/** A linear share as a screen shows it. @param {number} byte */
function display(byte) {
  const share = byte / 255;
  return Math.round(255 * (share <= 0.0031308 ? 12.92 * share : 1.055 * share ** (1 / 2.4) - 0.055));
}
