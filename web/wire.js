// SPDX-License-Identifier: Apache-2.0
// @ts-check
// The connection: messages in and out, the server's clock, and coming back after it was lost.
import {dropToken, now, put, putShow, putSmall} from "./store.js";

const WAITS_S = [0.5, 1, 2, 4];
const FETCH_WAITS_S = [0.5, 1, 2, 4];
export const NO_ANSWER = "Ghostlight does not answer.";
const NOT_THERE = "Ghostlight does not answer";
const NOTHING_CAME = "no answer came";
const PING_EVERY_MS = 20000;
const ANSWER_WITHIN_MS = 10000;
// A server that stands still, or a network that is gone, closes nothing. The state comes four times a second, the
// answer to a ping always. A line too slow for a large show is given more time the next time.
const SILENT_MS = 3000, MOST_SILENT_MS = 24000;
const LISTEN_EVERY_MS = 500;
const CONNECT_WITHIN_MS = 10000;
const LINE_LOST = "the line is lost", LINE_WAS_LOST = "the line was lost";

/** @type {WebSocket | null} */
let socket = null;
let lost = 0;  // times in a row
let timer = 0;
let token = "";
let beganMs = 0, heardMs = 0;  // when this connection began, since when nothing is heard over it
let listenedMs = 0;  // when that was looked at
let wordMs = 0;  // when something was heard last, over whichever
let patienceMs = SILENT_MS;
let leastTrip = Infinity, clockOffset = 0, pings = 0;  // ours + offset is the server's
/** @type {(message: DataView) => void} */
let onPicture = () => {};
/** @type {(why: string, isSentAway: boolean) => void} */
let onRefused = () => {};
let number = 0;  // of what was asked to be done
/** @type {Map<number, (refused: string) => void>} */
const asked = new Map();
const wishes = new Map();  // what the server is told again after each connection

/** @param {string} withToken @param {(message: DataView) => void} picture @param {(why: string, isSentAway: boolean) => void} refused */
export function begin(withToken, picture, refused) {
  token = withToken;
  onPicture = picture;
  onRefused = refused;
  lost = 0;
  const before = socket;
  socket = null;
  before?.close();
  put("began", token);
  connect();
}

function connect() {
  clearTimeout(timer);
  if (socket || !token) return;
  const opening = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/live`, ["ghostlight.1", `t.${token}`]);
  let wasOpen = false;
  socket = opening;
  beganMs = heardMs = performance.now();
  opening.binaryType = "arraybuffer";
  opening.onopen = () => {
    wasOpen = true;
    lost = 0;
    beganMs = heardMs = performance.now();
    leastTrip = Infinity;
    pings = 0;
    for (const wish of wishes.values()) opening.send(wish);
    put("isOpen", true);
    put("line", "live");
    ping();
  };
  opening.onmessage = (event) => {
    if (socket !== opening) return;
    heardMs = wordMs = performance.now();
    if (typeof event.data === "string")
      hearText(event.data);
    else
      hearBytes(new DataView(event.data));
  };
  opening.onclose = (event) => {
    if (socket !== opening) return;
    drop();
    if (wasOpen)
      leave(event.reason || LINE_WAS_LOST);
    else
      ask();
  };
}

// What was asked for over it is answered.
function drop() {
  const before = socket;
  socket = null;
  before?.close();
  put("isOpen", false);
  for (const answer of asked.values()) answer(LINE_WAS_LOST);
  asked.clear();
}

// Of a hidden tab nothing is expected, nor of a machine that slept: their time begins when they are back.
function listen() {
  const ms = performance.now();
  const wasAway = document.visibilityState !== "visible" || ms - listenedMs > 4 * LISTEN_EVERY_MS;
  listenedMs = ms;
  if (wasAway) beganMs = heardMs = ms;
  if (document.visibilityState !== "visible") return;
  if (socket?.readyState === WebSocket.CONNECTING && ms - beganMs > CONNECT_WITHIN_MS) {
    drop();
    leave(NOT_THERE);
  }
  if (socket?.readyState !== WebSocket.OPEN) return;
  if (wasAway || ms - heardMs > SILENT_MS / 3) ping();  // the state waits for pictures that are not painted
  if (ms - heardMs <= patienceMs) return;
  patienceMs = ms - beganMs > MOST_SILENT_MS ? SILENT_MS : Math.min(2 * patienceMs, MOST_SILENT_MS);
  drop();
  leave("nothing is heard");
}
setInterval(listen, LISTEN_EVERY_MS);

// Why a handshake was refused is hidden from a page; asked plainly, the server says whether the token is the
// right one.
async function ask() {
  try {
    const answer = await fetch("/right", {headers: {Authorization: `Bearer ${token}`}, cache: "no-store", signal: AbortSignal.timeout(CONNECT_WITHIN_MS)});
    if (answer.status !== 401) return leave(answer.ok ? "too many look on already" : `refused (${answer.status})`);
  } catch {
    return leave(NOT_THERE);
  }
  refuse("This address is no longer the right one: Ghostlight makes new ones.", false);
}

/** @param {string} why @param {boolean} isSentAway */
function refuse(why, isSentAway) {
  token = "";
  dropToken();
  drop();
  onRefused(why, isSentAway);
}

/** @param {string} why */
function leave(why) {
  const wait = WAITS_S[Math.min(lost++, WAITS_S.length - 1)];
  put("line", `${why}; trying again`);
  timer = setTimeout(connect, 1000 * wait);
}

function again() {
  if (socket || !token) return;
  lost = 0;
  connect();
}
addEventListener("online", again);
document.addEventListener("visibilitychange", () => {
  listen();
  if (document.visibilityState === "visible") again();
});

/** @param {string} text */
function hearText(text) {
  const message = JSON.parse(text);
  if (message.type === "pong")
    hearPong(message);
  else if (message.type === "bye")
    refuse(message.why, true);
  else if (message.type === "refused" && message.n === 0)
    put("refusedView", message.why);
  else if (message.type === "refused" || message.type === "done")
    hearAnswer(message);
  else if (message.type === "show")
    putShow(message);
  else if (["hello", "state", "messages", "explained", "looks", "measure"].includes(message.type))
    put(message.type, message);
}

/** @param {{n: number, why?: string}} message */
function hearAnswer(message) {
  asked.get(message.n)?.(message.why ?? "");
  asked.delete(message.n);
}

/** @param {DataView} bytes */
function hearBytes(bytes) {
  const kind = bytes.getUint8(0);
  if (kind === 1) onPicture(bytes);
  if (kind === 3) hearSmall(bytes);
  if (kind === 2) put("levels", {version: bytes.getUint16(2, true), count: bytes.getUint32(4, true), bytes});
}

/** @param {DataView} bytes */
function hearSmall(bytes) {
  const length = bytes.getUint16(2, true);
  const name = new TextDecoder().decode(new Uint8Array(bytes.buffer, 4, length));
  putSmall(bytes.getUint8(1) === 1 ? "look" : "camera", name, new Blob([new Uint8Array(bytes.buffer, 4 + length)], {type: "image/jpeg"}));
}

function ping() {
  say({type: "ping", t: performance.now()});
}
setInterval(ping, PING_EVERY_MS);

/** @param {{t: number, now_ms: number}} pong */
function hearPong(pong) {
  const trip = performance.now() - pong.t;
  if (trip < leastTrip) {
    leastTrip = trip;
    clockOffset = pong.now_ms - (pong.t + trip / 2);
  }
  if (++pings < 16) setTimeout(ping, 250);
}

/** Milliseconds since the server's clock showed that. @param {number} serverMs */
export function ageMs(serverMs) {
  return leastTrip === Infinity ? NaN : performance.now() + clockOffset - serverMs;
}

/** When the server was heard last, on the page's clock. */
export function heardAtMs() {
  return wordMs;
}

/** @param {object} message */
export function say(message) {
  if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
}

/**
 * Asks for something to be done, which needs the right to control. @param {string} what @param {(string |
 * number | boolean)[]} args @returns {Promise<string>} why not; "": it is done
 */
export function doIt(what, args) {
  if (socket?.readyState !== WebSocket.OPEN) return Promise.resolve(LINE_LOST);
  const n = ++number;
  say({type: "do", n, what, args});
  return new Promise((answer) => {
    asked.set(n, answer);
    setTimeout(() => hearAnswer({n, why: NOTHING_CAME}), ANSWER_WITHIN_MS);
  });
}

/** In a sentence. @param {string} refused what doIt() says; without an answer it may be done all the same */
export function outcome(refused) {
  if (refused === "") return "";
  return [LINE_WAS_LOST, NOTHING_CAME].includes(refused) ? `Perhaps not done: ${refused}.` : `Not done: ${refused}.`;
}

/**
 * Tries again while much is asked for. @param {string} path @returns {Promise<Response>} throws an Error with
 * a sentence where no answer comes
 */
export async function fetchWithToken(path) {
  for (let tries = 0;; ++tries) {
    const wait = FETCH_WAITS_S[tries];
    try {
      const answer = await fetch(path, {headers: {Authorization: `Bearer ${token}`}, cache: "no-store"});
      if (answer.status !== 503 || wait === undefined) return answer;
    } catch {
      if (wait === undefined) throw new Error(NO_ANSWER);
    }
    await new Promise((go) => setTimeout(go, 1000 * wait * (0.5 + Math.random())));
  }
}

/**
 * What holds until it is wished otherwise, over lost lines, too. @param {{type: string}} message
 * @param {boolean} isAgain said even if it holds already: the server may have refused it, or forgotten
 */
export function wish(message, isAgain = false) {
  const text = JSON.stringify(message);
  if (!isAgain && wishes.get(message.type) === text) return;
  wishes.set(message.type, text);
  say(message);
}

/** @param {number} number */
export function painted(number) {
  if (socket?.readyState !== WebSocket.OPEN) return;
  const bytes = new DataView(new ArrayBuffer(5));
  bytes.setUint8(0, 1);
  bytes.setUint32(1, number, true);
  socket.send(bytes.buffer);
}

export {now};
