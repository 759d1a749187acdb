// SPDX-License-Identifier: Apache-2.0
// @ts-check
// Pictures of the line on a canvas, and fingers over one.
import {make} from "./store.js";
import {painted} from "./wire.js";

const HEAD = 32;  // bytes before the JPEG

/** Which stream a picture is of: 0 the window's, 1 a side view. @param {DataView} message */
export function streamOf(message) {
  return message.getUint16(2, true);
}

export class Painter {
  /** @param {(message: DataView) => void} onPainted */
  constructor(onPainted) {
    this.canvas = /** @type {HTMLCanvasElement} */ (make("canvas", {role: "img", width: "16", height: "9"}));
    this.context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d", {alpha: false}));
    this.onPainted = onPainted;
    this.decoding = false;
    /** @type {DataView | null} */
    this.waiting = null;
  }

  /**
   * The newest one only: what comes while one is decoded waits, and gives way to the next. @param {DataView}
   * message
   */
  async take(message) {
    if (this.decoding) {
      this.waiting = message;
      return;
    }
    this.decoding = true;
    for (let next = /** @type {DataView | null} */ (message); next; this.waiting = null) {
      await this.paint(next);
      next = this.waiting;
    }
    this.decoding = false;
  }

  /** @param {DataView} message */
  async paint(message) {
    try {
      const bitmap = await createImageBitmap(new Blob([new Uint8Array(message.buffer, HEAD)], {type: "image/jpeg"}));
      await new Promise(requestAnimationFrame);  // a hidden tab paints nothing, says nothing, and gets nothing
      if (this.canvas.width !== bitmap.width || this.canvas.height !== bitmap.height) {
        this.canvas.width = bitmap.width;
        this.canvas.height = bitmap.height;
      }
      this.context.drawImage(bitmap, 0, 0);
      bitmap.close();
      this.onPainted(message);
    } catch {
      // A damaged picture: the next one comes all the same.
    }
    painted(message.getUint32(4, true));
  }
}

/**
 * Fingers, or a mouse, over an element. drag: one moved; pinch: two did, by a factor and to another middle;
 * tap: one that did not move; end: the last one is gone. Pixels of the page.
 * @param {HTMLElement} element
 * @param {{drag: (dx: number, dy: number) => void,
 *          pinch: (factor: number, x: number, y: number, dx: number, dy: number) => void,
 *          tap: (x: number, y: number) => void, end: () => void}} told
 */
export function hearFingers(element, told) {
  /** @type {Map<number, {x: number, y: number}>} */
  const fingers = new Map();
  let strayed = false;
  element.addEventListener("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    if (fingers.size === 0) strayed = false;
    fingers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    if (fingers.size > 1) strayed = true;
  });
  element.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const other = [...fingers.entries()].find(([id]) => id !== event.pointerId)?.[1];
    const after = {x: event.clientX, y: event.clientY};
    const dx = after.x - before.x, dy = after.y - before.y;
    if (Math.hypot(dx, dy) > 3) strayed = true;
    if (other) {
      const spread = (/** @type {{x: number, y: number}} */ a) => Math.max(Math.hypot(a.x - other.x, a.y - other.y), 1);
      told.pinch(spread(after) / spread(before), (after.x + other.x) / 2, (after.y + other.y) / 2, dx / 2, dy / 2);
    } else if (strayed) {
      told.drag(dx, dy);
    } else {
      return;
    }
    fingers.set(event.pointerId, after);
  });
  for (const name of ["pointerup", "pointercancel"])
    element.addEventListener(name, (event) => {
      const {pointerId, clientX, clientY} = /** @type {PointerEvent} */ (event);
      if (!fingers.delete(pointerId) || fingers.size > 0) return;
      if (!strayed && name === "pointerup") told.tap(clientX, clientY);
      told.end();
    });
}
