// SPDX-License-Identifier: Apache-2.0
// @ts-check
// Which screen is shown, and the way in.
import "./book.js";
import "./looks.js";
import "./rig.js";
import "./state.js";

import {streamOf} from "./draw.js";
import {takePicture} from "./picture.js";
import {hear, keepToken, make, mayControl, now, plain, putText, takeToken, tokenBefore} from "./store.js";
import {takeSide} from "./stage.js";
import {begin, NO_ANSWER} from "./wire.js";

const SCREENS = ["picture", "rig", "looks", "stage", "book", "state"];
const TAKEN_BACK_MS = 30000;
const wide = matchMedia("(min-width: 900px)");
let screen = "picture";
let isIn = false;

const line = /** @type {HTMLElement} */ (document.querySelector("#line"));
const spoken = /** @type {HTMLElement} */ (document.querySelector("#spoken"));
const nav = /** @type {HTMLElement} */ (document.querySelector("nav"));
const main = /** @type {HTMLElement} */ (document.querySelector("main"));

/** @param {string} name */
function at(name) {
  return /** @type {HTMLElement} */ (document.querySelector(`ghost-${name}`));
}

function lay() {
  const both = wide.matches && screen === "picture";
  main.classList.toggle("wide", isIn && both);
  nav.hidden = !isIn;
  for (const name of SCREENS) {
    at(name).hidden = !isIn || !(name === screen || (both && name === "rig"));
    const button = /** @type {HTMLElement} */ (nav.querySelector(`[data-screen=${name}]`));
    if (name === screen)
      button.setAttribute("aria-current", "page");
    else
      button.removeAttribute("aria-current");
  }
  at("pair").hidden = isIn;
  if (screen !== "picture" || !isIn) document.body.classList.remove("alone");
  dispatchEvent(new Event("resize"));
}

/** @param {string} name */
function show(name) {
  screen = name;
  lay();
}

nav.addEventListener("click", (event) => {
  const name = /** @type {HTMLElement} */ (event.target).dataset.screen;
  if (name) show(name);
});
wide.addEventListener("change", lay);
/** @param {EventTarget | null} element */
function takesText(element) {
  return element instanceof HTMLInputElement && element.type !== "range";
}

addEventListener("keydown", (event) => {
  if (!isIn || event.ctrlKey || event.altKey || event.metaKey || takesText(event.target)) return;
  const name = SCREENS[Number(event.key) - 1];
  if (name) show(name);
});

hear("line", () => {
  const isLost = now.line !== "live";
  if (isLost !== line.classList.contains("lost")) spoken.textContent = isLost ? `The line is lost: ${now.line}` : "The line is back";
  line.textContent = isLost ? now.line : now.line + tookBack;
  line.classList.toggle("lost", isLost);
});
let didControl = false;
let tookBack = "", tookBackTimer = 0;
hear("hello", () => {
  const isLess = didControl && !mayControl();
  didControl = mayControl();
  if (!isLess && !didControl) return;
  tellTakenBack(isLess);
  // What had the keyboard may be gone.
  if (isLess && (document.activeElement === document.body || document.activeElement?.closest("[hidden]"))) main.focus();
});
/** @param {boolean} isTold */
function tellTakenBack(isTold) {
  clearTimeout(tookBackTimer);
  tookBack = isTold ? "; control was taken back" : "";
  if (isTold) {
    spoken.textContent = "Control was taken back: you look on.";
    tookBackTimer = setTimeout(() => tellTakenBack(false), TAKEN_BACK_MS);
  }
  if (now.line === "live") line.textContent = now.line + tookBack;
}
hear("show", () => {
  const name = now.show.name || "Ghostlight";
  putText(/** @type {HTMLElement} */ (document.querySelector("#show")), name);
  document.title = plain(`${name} - Ghostlight`);
});
let cue = "";
hear("state", () => {
  if (now.state.cue && now.state.cue !== cue && cue) putText(spoken, `Cue ${now.state.cue}`);
  cue = now.state.cue ?? "";
});

class Pair extends HTMLElement {
  connectedCallback() {
    const digits = /** @type {HTMLInputElement} */ (
        make("input", {inputmode: "numeric", autocomplete: "off", maxlength: "6", pattern: "[0-9]{6}", required: ""}));
    const wrong = make("p", {class: "wrong", role: "alert"});
    const form = make("form", {}, make("label", {}, "Six digits", digits), make("button", {type: "submit"}, "Look on"));
    form.addEventListener("submit", async (event) => {
      event.preventDefault();
      wrong.textContent = "";
      try {
        const asked = {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify({code: digits.value})};
        const answer = await fetch("/pair", asked).catch(() => Promise.reject(new Error(NO_ANSWER)));
        if (!answer.ok)
          throw new Error(
              answer.status === 401 ? "These are not the digits, or they are no longer: they hold for two minutes and five tries." :
                                      await answer.text());
        const {token} = await answer.json();
        keepToken(token);
        enter(token);
      } catch (problem) {
        wrong.textContent = /** @type {Error} */ (problem).message;
      }
    });
    this.append(
        make("h2", {}, "Who may look on"),
        make("p", {}, "Open the whole address that Ghostlight printed, scan its code, or type the six digits beside it."),
        form,
        wrong,
    );
  }
}
customElements.define("ghost-pair", Pair);

/** @param {string} token */
function enter(token) {
  isIn = true;
  lay();
  begin(token, (message) => (streamOf(message) === 0 ? takePicture(message) : takeSide(message)), (why, isSentAway) => {
    const other = isSentAway ? "" : tokenBefore();
    if (other) {
      spoken.textContent = "That address is not the right one; the one before is gone on with.";
      enter(other);
      return;
    }
    isIn = false;
    didControl = false;
    line.textContent = why;
    line.classList.add("lost");
    lay();
  });
}

function comeIn() {
  const token = takeToken();
  if (token)
    enter(token);
  else
    lay();
}
addEventListener("hashchange", comeIn);
comeIn();
