// SPDX-License-Identifier: Apache-2.0
// @ts-check
// A camera that goes round a point. Metres, radians but for the field of view; Z up. Pure.
const PITCH_MOST = 1.53;  // from level: straight down there is no right
const NEAREST_M = 0.3, FARTHEST_M = 2000;

/** @typedef {{target: number[], yaw: number, pitch: number, distance: number, fov: number}} Orbit */

/** @param {{position_m: number[], target_m: number[], fov_y_deg: number}} camera @returns {Orbit} */
export function orbitOf(camera) {
  const d = camera.position_m.map((value, k) => value - camera.target_m[k]);
  const distance = Math.min(Math.max(Math.hypot(...d), NEAREST_M), FARTHEST_M);
  return {
    target: [...camera.target_m],
    yaw: Math.atan2(d[0], -d[1]),
    pitch: Math.asin(Math.min(Math.max(d[2] / distance, -1), 1)),
    distance,
    fov: Math.min(Math.max(camera.fov_y_deg, 1), 120),
  };
}

/** @param {Orbit} orbit */
export function cameraOf({target, yaw, pitch, distance, fov}) {
  const away = [Math.sin(yaw) * Math.cos(pitch), -Math.cos(yaw) * Math.cos(pitch), Math.sin(pitch)];
  return {
    position_m: target.map((value, k) => round(value + distance * away[k])),
    target_m: target.map(round),
    fov_y_deg: round(fov),
  };
}

/** As it is sent. @param {number} value */
export function round(value) {
  return Math.round(Math.min(Math.max(value, -10000), 10000) * 1000) / 1000;
}

/** Along the picture, by shares of its height. @param {Orbit} orbit @param {number} right @param {number} up */
export function slide(orbit, right, up) {
  const size = 2 * orbit.distance * Math.tan((orbit.fov * Math.PI) / 360);
  const {yaw, pitch} = orbit;
  const r = [Math.cos(yaw), Math.sin(yaw), 0];
  const u = [-Math.sin(yaw) * Math.sin(pitch), Math.cos(yaw) * Math.sin(pitch), Math.cos(pitch)];
  orbit.target = orbit.target.map((value, k) => value + size * (right * r[k] + up * u[k]));
}

/** @param {Orbit} orbit @param {number} yaw @param {number} pitch */
export function turn(orbit, yaw, pitch) {
  orbit.yaw += yaw;
  orbit.pitch = Math.min(Math.max(orbit.pitch + pitch, -PITCH_MOST), PITCH_MOST);
}

/** Nearer by that factor. @param {Orbit} orbit @param {number} factor */
export function dolly(orbit, factor) {
  orbit.distance = Math.min(Math.max(orbit.distance / factor, NEAREST_M), FARTHEST_M);
}
