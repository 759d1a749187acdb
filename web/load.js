// SPDX-License-Identifier: Apache-2.0
// @ts-check
// Before all else: where a file of the page did not come, because many open it at once, the page opens itself
// again. A script that is missing would leave it dead.
addEventListener("error", ({target}) => {
  if (target instanceof HTMLScriptElement || target instanceof HTMLLinkElement) setTimeout(() => location.reload(), 500 + 1500 * Math.random());
}, true);
