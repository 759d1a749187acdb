// SPDX-License-Identifier: Apache-2.0
// @ts-check
// What the server said last, and who wants to hear of it. The token is in the address's fragment once, and
// then in this tab's session storage alone.

const told = new Map();

export const now = {
  /** @type {any} */ show: null,
                     /** @type {any} */
                     state: null,
                     /** @type {any} */
                     messages: null,
                     /** @type {any} */
                     explained: null,
                     /** @type {any} */
                     hello: null,
                     /** @type {any} */
                     looks: null,
                     /** @type {any} */
                     measure: null,
                     refusedView: "",
                     /** @type {{version: number, count: number, bytes: DataView} | null} */
                     levels: null,
                     latencyMs: NaN,      // from the desk's packet to the screen, of the newest picture that has one
                     line: "connecting",  // what the connection is like, in words
                     isOpen: false,
                     began: "",  // the token of the server that is looked at
};

/** @param {string} topic @param {() => void} tell */
export function hear(topic, tell) {
  if (!told.has(topic)) told.set(topic, []);
  told.get(topic).push(tell);
}

/** @param {string} topic @param {any} value */
export function put(topic, value) {
  now[topic] = value;
  for (const tell of told.get(topic) ?? []) tell();
}

export function mayControl() {
  return now.hello?.right === "control";
}

// Small pictures by kind and name, as blobs. Those of another show go with it.
const small = new Map();

/** @param {"camera" | "look"} kind @param {string} name @returns {string} its URL; "": there is none yet */
export function smallPicture(kind, name) {
  return small.get(`${kind} ${name}`) ?? "";
}

/** @param {"camera" | "look"} kind @param {string} name @param {Blob} blob */
export function putSmall(kind, name, blob) {
  const key = `${kind} ${name}`;
  if (small.has(key)) URL.revokeObjectURL(small.get(key));
  small.set(key, URL.createObjectURL(blob));
  put("small", key);
}

/** @param {any} show of another show the small pictures go first */
export function putShow(show) {
  if (now.show && now.show.opens !== show.opens) {
    for (const url of small.values()) URL.revokeObjectURL(url);
    small.clear();
    put("small", "");
  }
  put("show", show);
}

const CALM_KEY = "ghostlight-calm";
const lessMotion = matchMedia("(prefers-reduced-motion: reduce)");
let calm = chosenCalm() ?? lessMotion.matches;
lessMotion.addEventListener("change", () => {
  calm = lessMotion.matches || chosenCalm() === true;
  put("calm", calm);
});

// What was chosen before, in this browser; a page may have no storage.
function chosenCalm() {
  try {
    const kept = localStorage.getItem(CALM_KEY);
    return kept === null ? null : kept === "on";
  } catch {
    return null;
  }
}

/** Two pictures a second, against strobes. */
export function isCalm() {
  return calm;
}

/** @param {boolean} wanted */
export function setCalm(wanted) {
  calm = wanted;
  try {
    localStorage.setItem(CALM_KEY, wanted ? "on" : "off");
  } catch {
    // It holds until the page is left.
  }
  put("calm", wanted);
}

/** @param {number} paintedMs of what is kept on a lost line @returns {string} how old it is */
export function age(paintedMs) {
  return `${Math.round((performance.now() - paintedMs) / 1000)} s old`;
}

/** @param {HTMLElement} element @param {() => void} tell when it is shown, or no more */
export function onShown(element, tell) {
  new MutationObserver(tell).observe(element, {attributes: true, attributeFilter: ["hidden"]});
}

/** @param {string} screen */
export function isHidden(screen) {
  return /** @type {HTMLElement | null} */ (document.querySelector(`ghost-${screen}`))?.hidden ?? true;
}

const KEY = "ghostlight-token";
let before = "";  // the token that this tab had when it was given another one

export function takeToken() {
  const given = /^#t=([0-9a-f]{32})$/.exec(location.hash);
  if (given) {
    before = sessionStorage.getItem(KEY) ?? "";
    if (before === given[1]) before = "";
    sessionStorage.setItem(KEY, given[1]);
    history.replaceState(null, "", location.pathname);
  }
  return sessionStorage.getItem(KEY);
}

/** @returns {string} instead of one that was refused; "": there was none */
export function tokenBefore() {
  const token = before;
  before = "";
  if (token) keepToken(token);
  return token;
}

/** @param {string} token */
export function keepToken(token) {
  sessionStorage.setItem(KEY, token);
}

export function dropToken() {
  sessionStorage.removeItem(KEY);
}

/**
 * What turns the order of the letters behind it, and what is no letter, is shown instead, as on paper.
 * @param {string} text
 */
export function plain(text) {
  return text.replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u202a-\u202e\u2066-\u2069]/g, (letter) => `\\u${letter.charCodeAt(0).toString(16).padStart(4, "0")}`);
}

/** @param {Element} element @param {string} text with names in it */
export function putText(element, text) {
  const said = plain(text);
  if (element.textContent !== said) element.textContent = said;  // a live region says what changes
}

/**
 * Text into elements, never mark-up: names come from strangers. @param {string} name @param {Record<string,
 * string>} [attributes] @param {(Node | string)[]} children
 */
export function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, key === "src" ? value : plain(value));
  element.append(...children.map((child) => (typeof child === "string" ? plain(child) : child)));
  return element;
}

/** @param {string} url of a small picture; "": there is none yet @param {string} when it will be drawn */
export function thumbnail(url, when) {
  return url ? make("img", {src: url, alt: ""}) : make("span", {}, `drawn ${when}`);
}

/** @param {number} seconds */
export function clock(seconds) {
  const whole = Math.floor(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}
