// SPDX-License-Identifier: Apache-2.0
// @ts-check
// The looks of the show as cards, the one that is there now marked; with control they are recalled, and cues
// are called.
import {hear, isHidden, make, mayControl, now, onShown, smallPicture, thumbnail} from "./store.js";
import {doIt, outcome, wish} from "./wire.js";

const WHEN = "when the lamps rest";

class Looks extends HTMLElement {
  connectedCallback() {
    this.seconds = /** @type {HTMLInputElement} */ (
        make("input", {type: "number", min: "0", max: "3600", step: "0.5", placeholder: "as stored", inputmode: "decimal"}));
    this.said = make("p", {class: "said-now", role: "status"});
    this.tools = make(
        "div", {class: "tools"}, make("label", {}, "Fade, seconds", this.seconds), this.button("Cue back", () => this.order("cue/back", [])),
        this.button("Cue go", () => this.order("cue/go", [])));
    this.about = make("p", {class: "quiet"});
    this.cards = make("ul", {class: "cards"});
    this.append(this.tools, this.said, this.about, this.cards);
    /** @type {Map<string, {item: HTMLElement, picture: HTMLElement, state: HTMLElement, url: string}>} */
    this.rows = new Map();
    for (const topic of ["looks", "hello", "show"]) hear(topic, () => this.build());
    // What was not done is another matter then.
    for (const topic of ["isOpen", "hello"]) hear(topic, () => now.isOpen && this.tell(""));
    hear("small", () => this.paint());
    onShown(this, () => {
      this.paint();
      wish({type: "pictures", on: !isHidden("looks") || !isHidden("stage")});
    });
    this.build();
  }

  /** @param {string} name @param {() => void} click */
  button(name, click) {
    const button = make("button", {type: "button"}, name);
    button.addEventListener("click", click);
    return button;
  }

  /** @param {string} what @param {(string | number)[]} args */
  async order(what, args) {
    this.wanted = what === "look" ? String(args[0]) : "";
    const refused = await doIt(what, args);
    if (refused === "" || this.wanted === "" || this.wanted !== now.looks?.current) this.tell(outcome(refused));
  }

  /** @param {string} said */
  tell(said) {
    this.said.textContent = said;
    this.said.classList.toggle("bad", said !== "");
  }

  /** @param {string} name */
  recall(name) {
    const seconds = this.seconds.value === "" ? [] : [Math.min(Math.max(Number(this.seconds.value), 0), 3600)];
    this.order("look", [name, ...seconds]);
  }

  build() {
    const looks = now.looks?.looks ?? [];
    if (this.wanted && this.wanted === now.looks?.current) this.tell("");  // however late
    this.tools.hidden = !mayControl();
    for (const button of this.tools.querySelectorAll("button")) button.hidden = !now.show?.cues?.length;
    this.about.textContent = looks.length === 0 ? "The show has no looks: the window stores them, in its panel Looks." :
        mayControl()                            ? "" :
                                                  "To look at: who has the address with control recalls them.";
    this.about.hidden = this.about.textContent === "";
    const shape = JSON.stringify([looks, mayControl()]);
    if (shape !== this.shape) {
      this.shape = shape;
      this.rows = new Map(looks.map((/** @type {any} */ look) => [look.name, this.card(look)]));
      this.cards.replaceChildren(...[...this.rows.values()].map((row) => row.item));
    }
    for (const [name, row] of this.rows) {
      const isNow = name === now.looks?.current;
      row.item.classList.toggle("now", isNow);
      row.state.hidden = !isNow;
      if (isNow)
        row.item.setAttribute("aria-current", "true");
      else
        row.item.removeAttribute("aria-current");
    }
    this.paint();
  }

  /** @param {{name: string, fade_s: number, fixtures: number}} look */
  card(look) {
    const picture = make("div", {class: "thumb"}, thumbnail("", WHEN));
    const state = make("span", {class: "badge"}, "Now");
    const facts = `${look.fixtures} ${look.fixtures === 1 ? "lamp" : "lamps"} \u00b7 ${look.fade_s ? `${Number(look.fade_s.toFixed(1))} s` : "at once"}`;
    const words = make("div", {class: "words"}, make("span", {class: "name"}, look.name), state, make("span", {class: "quiet"}, facts));
    const item = make("li", {class: "card"});
    if (mayControl()) {
      const button = make("button", {type: "button", "aria-label": `Recall ${look.name}`}, picture, words);
      button.addEventListener("click", () => this.recall(look.name));
      item.append(button);
    } else {
      item.append(picture, words);
    }
    return {item, picture, state, url: ""};
  }

  paint() {
    if (this.hidden) return;
    for (const [name, row] of this.rows) {
      const url = smallPicture("look", name);
      if (url === row.url) continue;
      row.url = url;
      row.picture.replaceChildren(thumbnail(url, WHEN));
    }
  }
}
customElements.define("ghost-looks", Looks);
