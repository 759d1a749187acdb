// SPDX-License-Identifier: Apache-2.0
// @ts-check
// The cue book, and how far it is from an older one. Its files come with the token in a header, so pictures
// are blobs; each is fetched when it is nearly seen.
import {clock, hear, make, now, onShown, putText} from "./store.js";
import {fetchWithToken} from "./wire.js";

const MOST_AT_ONCE = 4;
const MOST_NAMES = 6;
const TURN_MS = 500;  // of a picture, of two by turns

class Book extends HTMLElement {
  connectedCallback() {
    this.text = "";
    this.bar = make("div", {class: "tools"});
    const again = make("button", {type: "button"}, "Read it again");
    again.addEventListener("click", () => this.read(true));
    this.about = make("p", {class: "quiet", role: "status"});
    this.bar.append(this.about, again);
    this.body = make("div");
    this.append(this.bar, this.body);
    /** @type {HTMLImageElement[]} */
    this.wanted = [];
    /** @type {string[]} */
    this.urls = [];
    this.fetching = 0;
    this.round = 0;
    this.reading = 0;
    this.isReading = false;
    this.opens = -1;
    this.watcher = new IntersectionObserver((seen) => {
      for (const {isIntersecting, target} of seen) {
        if (!isIntersecting) continue;
        this.watcher.unobserve(target);
        this.wanted.push(/** @type {HTMLImageElement} */ (target));
      }
      this.fetchNext();
    }, {rootMargin: "400px"});
    onShown(this, () => this.read(false));
    hear("isOpen", () => this.read(false));
    hear("began", () => {
      this.opens = -1;
      this.forget();
    });
    hear("show", () => {
      if (this.opens === now.show.opens) return;
      if (this.opens >= 0) this.forget();
      this.opens = now.show.opens;
      this.read(false);
    });
  }

  // Of another server or show; what is on its way is of the one before.
  forget() {
    ++this.reading;
    this.isReading = false;
    this.text = "";
    this.about.textContent = "";
    this.clear();
    this.body.replaceChildren();
  }

  clear() {
    ++this.round;
    for (const url of this.urls) URL.revokeObjectURL(url);
    this.urls = [];
    this.wanted = [];
    this.watcher.disconnect();
  }

  /** @param {boolean} anew */
  async read(anew) {
    if (this.hidden || !now.isOpen || this.isReading || (this.text && !anew)) return;
    this.isReading = true;
    const reading = ++this.reading;
    this.about.textContent = "Reading the book ...";
    try {
      const answer = await fetchWithToken("/book/book.json");
      const text = await answer.text();
      if (!answer.ok) throw new Error(text.trim());
      const none = JSON.parse(text).none;
      if (none) throw new Error(none);
      const other = await fetchWithToken("/book/difference.json");
      const words = await other.text();
      const problem = other.ok ? "" : `What became of the older book cannot be shown: ${words.trim()}`;
      if (reading !== this.reading) return;
      this.build(JSON.parse(text), other.ok ? JSON.parse(words) : null, problem);
      this.text = text;
    } catch (problem) {
      if (reading !== this.reading) return;
      this.about.textContent = `${/** @type {Error} */ (problem).message}`;
    }
    this.isReading = false;
  }

  /** @param {any} book @param {any} difference null: there is none @param {string} problem why it is not shown */
  build(book, difference, problem) {
    this.clear();
    this.size = {width: String(book.size[0]), height: String(book.size[1])};
    const {length} = book.entries;
    putText(this.about, `${book.show || "The show"}: ${length} ${length === 1 ? "entry" : "entries"} (${book.kind}), drawn by ${book.device}`);
    const hasNumbers = book.entries.some((/** @type {any} */ entry) => entry.number);
    this.body.replaceChildren(
        ...(problem ? [make("p", {class: "bad"}, problem)] : []),
        ...(difference ? [this.difference(difference)] : []),
        ...book.entries.map((/** @type {any} */ entry, /** @type {number} */ index) => this.entry(entry, index, hasNumbers, !book.for_client))); // a tour names no fixtures
  }

  /** @param {any} entry @param {number} index @param {boolean} hasNumbers one of the book has @param {boolean} hasChanges */
  entry(entry, index, hasNumbers, hasChanges) {
    const times = [
      entry.at_s === null ? "" : `at ${moment(entry.at_s)}`,
      entry.page ? `page ${entry.page} of the script` : "",
      entry.fade_s === null ? "" : entry.fade_s > 0 ? `fades ${entry.fade_s} s` : "at once",
      entry.follow_s === null ? "" : `the next one follows after ${entry.follow_s} s`,
      entry.look ? `look ${entry.look}` : "",
    ].filter(Boolean);
    const changes = entry.changes.map((/** @type {any} */ change) => `${names(change.fixtures)}: ${change.what}`);
    const number = entry.number || (hasNumbers ? "" : String(index + 1));
    return make(
        "article", {class: "entry"}, make("h2", {}, number ? `${number}. ${entry.name}` : entry.name),
        ...(times.length ? [make("p", {class: "quiet"}, times.join(" \u00b7 "))] : []),
        ...(entry.notes ? [make("p", {}, entry.notes)] : []),
        make(
            "div", {class: "pictures"},
            ...entry.pictures.map((/** @type {any} */ picture) => this.figure(picture.file, `${entry.name} from ${picture.camera}`, picture.camera))),
        ...(entry.unknown.length ? [list(entry.unknown, "quiet")] : []),
        ...(hasChanges ? [make("h3", {}, index === 0 ? "From the dark" : "What changes"), changes.length ? list(changes) : make("p", {class: "quiet"}, "nothing that is seen")] : []));
  }

  /** @param {any} difference */
  difference(difference) {
    const part = (/** @type {string} */ name, /** @type {string[]} */ sentences) =>
        [make("h3", {}, name), sentences.length ? list(sentences) : make("p", {class: "quiet"}, "no change")];
    const differ = difference.pictures.filter((/** @type {any} */ picture) => picture.old_file);
    const others = difference.pictures.length - differ.length;
    return make(
        "section", {class: "entry"}, make("h2", {}, `Since ${difference.old_name}`), ...(difference.unknown.length ? [list(difference.unknown, "quiet")] : []),
        ...part("Entries", difference.entries), ...part("Fixtures", difference.fixtures), make("h3", {}, "Pictures"),
        ...differ.map((/** @type {any} */ picture) => this.slider(picture)),
        make("p", {class: "quiet"}, `${others} ${others === 1 ? "picture is" : "pictures are"} the same or not compared`));
  }

  /** @param {any} picture */
  slider(picture) {
    const name = `${picture.name} from ${picture.camera}`;
    const old = this.image(picture.old_file, `${name}, before`);
    old.classList.add("old-one");
    const range = /** @type {HTMLInputElement} */ (make("input", {type: "range", min: "0", max: "100", value: "50", "aria-label": `How much of the older picture covers ${name}`}));
    const cut = () => (old.style.clipPath = `inset(0 ${100 - Number(range.value)}% 0 0)`);
    range.addEventListener("input", cut);
    cut();
    const button = make("button", {type: "button", "aria-pressed": "false"}, "By turns");
    let turns = 0;
    button.addEventListener("click", () => {
      clearInterval(turns);
      turns = turns ? 0 : setInterval(() => {
        if (!range.isConnected) return clearInterval(turns); // the book was read again
        range.value = Number(range.value) > 50 ? "0" : "100";
        cut();
      }, TURN_MS);
      button.setAttribute("aria-pressed", String(turns > 0));
    });
    return make(
        "div", {class: "pictures"},
        make(
            "figure", {}, make("div", {class: "slide"}, this.image(picture.file, `${name}, now`), old), range, button,
            make("figcaption", {}, `${name}: ${picture.seen}; left before, right now`)),
        this.figure(picture.map_file, `Where ${name} differs`, "where they differ: black not at all, yellow most"));
  }

  /** @param {string} file @param {string} words @param {string} caption */
  figure(file, words, caption) {
    return make("figure", {}, this.image(file, words), make("figcaption", {}, caption));
  }

  /** @param {string} file @param {string} words */
  image(file, words) {
    const image = /** @type {HTMLImageElement} */ (make("img", {alt: words, ...this.size}));
    image.dataset.file = file;
    this.watcher.observe(image);
    return image;
  }

  async fetchNext() {
    while (this.fetching < MOST_AT_ONCE && this.wanted.length > 0) {
      const image = /** @type {HTMLImageElement} */ (this.wanted.shift());
      ++this.fetching;
      this.fetchOne(image, this.round).finally(() => {
        --this.fetching;
        this.fetchNext();
      });
    }
  }

  /** @param {HTMLImageElement} image @param {number} round */
  async fetchOne(image, round) {
    try {
      const answer = await fetchWithToken(`/book/${image.dataset.file}`);
      if (!answer.ok) throw new Error((await answer.text()).trim());
      const url = URL.createObjectURL(await answer.blob());
      if (round !== this.round) return URL.revokeObjectURL(url);
      this.urls.push(url);
      image.src = url;
    } catch (problem) {
      image.replaceWith(make("p", {class: "bad"}, `${image.alt}: ${/** @type {Error} */ (problem).message}`));
    }
  }
}
customElements.define("ghost-book", Book);

/** To a hundredth of a second, never later than it is. @param {number} seconds */
function moment(seconds) {
  const hundredths = Math.floor(seconds * 100 + 1e-4);
  return clock(Math.floor(hundredths / 100)) + String((hundredths % 100) / 100).slice(1);
}

/** @param {string[]} fixtures */
function names(fixtures) {
  const more = fixtures.length - MOST_NAMES;
  return more > 0 ? `${fixtures.slice(0, MOST_NAMES).join(", ")} and ${more} more` : fixtures.join(", ");
}

/** @param {string[]} sentences */
function list(sentences, look = "") {
  return make("ul", look ? {class: look} : {}, ...sentences.map((one) => make("li", {}, one)));
}
