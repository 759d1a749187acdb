// SPDX-License-Identifier: Apache-2.0
// @ts-check
// Is the desk heard, who sends what, who looks on, what was said.
import {clock, hear, make, now} from "./store.js";

class State extends HTMLElement {
  connectedCallback() {
    this.picture = make("dl", {class: "facts"});
    this.desk = make("div");
    this.viewers = make("div");
    this.said = make("ul", {class: "said"});
    this.append(
        make("h2", {}, "Picture"),
        this.picture,
        make("h2", {}, "Desk"),
        this.desk,
        make("h2", {}, "Who looks on"),
        this.viewers,
        make("h2", {}, "Messages"),
        this.said,
    );
    hear("state", () => this.tell());
    hear("show", () => this.tell());
    hear("messages", () => this.list());
    new MutationObserver(() => this.tell()).observe(this, {attributes: true, attributeFilter: ["hidden"]});
    this.list();
  }

  tell() {
    const state = now.state;
    if (!state || this.hidden) return;
    const facts = [
      ["Camera", state.camera || "free"],
      ["Drawn", state.supply || "live"],
      ["Time of a picture", state.draw_ms === undefined ? "no picture yet" : `${state.draw_ms.toFixed(1)} ms`],
      ["Levels", {desk: "from the desk", recording: "from the recording", none: "none"}[state.source] ?? "not known yet"],
      ["Lamps", state.lamps === undefined ? "not known yet" : `${state.shining} of ${state.lamps} shine`],
    ];
    if (state.source === "recording") facts.push(["Recording", `${clock(state.at_s)} of ${clock(state.recording_s)}`]);
    if (state.cue) facts.push(["Cue", state.cue]);
    if (now.looks?.current) facts.push(["Look", now.looks.current]);
    if (state.timecode) facts.push(["Time code", state.timecode]);
    if (Number.isFinite(now.latencyMs)) facts.push(["From the desk to this screen", `${Math.round(now.latencyMs)} ms`]);
    if (state.work_light) facts.push(["Work light", "on"]);
    if (now.show?.device) facts.push(["Graphics device", now.show.device]);
    this.picture.replaceChildren(...facts.flatMap(([name, value]) => [make("dt", {}, name), make("dd", {}, value)]));
    this.tellDesk(state.desk);
    this.viewers.replaceChildren(table(
        ["Address", "Since", "Pictures a second", "Width"],
        state.viewers.map(
            (/** @type {any} */ viewer) => [viewer.controls ? `${viewer.from}, may control` : viewer.from, clock(viewer.seconds), String(viewer.rate_hz), `${viewer.width} px at most`])));
  }

  /** @param {any} desk */
  tellDesk(desk) {
    if (!desk) {
      this.desk.replaceChildren(make("p", {class: "quiet"}, "Nothing is listened to."));
      return;
    }
    const parts = [];
    if (desk.trouble) parts.push(make("p", {class: "bad"}, `Not listening: ${desk.trouble}`));
    for (const problem of desk.problems) parts.push(make("p", {}, problem));
    if (desk.sources.length === 0)
      parts.push(make("p", {class: "quiet"}, "No desk is heard."));
    else
      parts.push(table(
          ["Source", "Universe", "Protocol", "Rate", "Priority"],
          desk.sources.map(
              (/** @type {any} */ source) =>
                  [source.name ? `${source.name} (${source.from})` : source.from, String(source.universe), source.protocol,
                   source.age_s > 3 ? `silent for ${Math.round(source.age_s)} s` : `${source.rate_hz.toFixed(1)} Hz`,
                   String(source.priority)])));
    if (desk.more > 0) parts.push(make("p", {class: "quiet"}, `and ${desk.more} more`));
    this.desk.replaceChildren(...parts);
  }

  list() {
    const said = now.messages;
    const rows =
        (said?.messages ??
         []).map((/** @type {any} */ message) => make("li", message.severity === "error" ? {class: "bad"} : {}, `${{
                                                        note: "Note",
                                                        warning: "Warning",
                                                        error: "Error"
                                                      }[message.severity]}: ${message.where ? `${message.where}: ` : ""}${message.what}`));
    if (said?.more > 0) rows.unshift(make("li", {class: "quiet"}, `${said.more} older ones are left out`));
    this.said.replaceChildren(...(rows.length > 0 ? rows : [make("li", {class: "quiet"}, "None.")]));
  }
}
customElements.define("ghost-state", State);

/** @param {string[]} heads @param {string[][]} rows */
function table(heads, rows) {
  const head = make("thead", {}, make("tr", {}, ...heads.map((one) => make("th", {scope: "col"}, one))));
  const body = make("tbody", {}, ...rows.map((cells) => make("tr", {}, ...cells.map((cell) => make("td", {}, cell)))));
  return make("div", {class: "wide-table"}, make("table", {}, head, body));
}
