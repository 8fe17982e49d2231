"use strict";
// The page of a running monitor. Whatever it has not heard of lately is not safe.

const STATUS_EVERY_MS = 250;
const PICTURE_EVERY_MS = 160;
const ANSWER_WITHIN_MS = 1200;
const OLD_AFTER_MS = 1000;  // of the decision, with the way of the answer

const at = (id) => document.getElementById(id);
let session = { may_look: false, token: null };
let sessionIsOld = true;
let last = null;      // the last status
let lastAsked = null; // when it was asked for: performance.now()
let pictureTaken = -Infinity;  // by the same clock, not later than this
let beat = false;
let newestEvent = null;
let shownEvents = [];

const STATES = {
  safe: ["SAFE", "Nothing is in the skin, and nothing is wrong."],
  alarm: ["ALARM", "Something is in the skin."],
  not_safe: ["NOT SAFE", "The monitor has stopped the machine."],
  old: ["NOT SAFE", "The monitor decides no more: its last decision is too old."],
  none: ["NO CONNECTION", "The page hears nothing from the monitor. Take it for not safe."],
};

function element(name, text, className) {
  const made = document.createElement(name);
  if (text !== undefined && text !== null) made.textContent = text;
  if (className) made.className = className;
  return made;
}

function row(cells, className) {
  const tr = element("tr", null, className);
  for (const cell of cells) tr.append(cell instanceof Node ? cell : element("td", cell));
  return tr;
}

// The time is that of the whole answer, not of its headers: what has been read by then stays.
function ask(path, options = {}) {
  const stop = new AbortController();
  setTimeout(() => stop.abort(), options.within || ANSWER_WITHIN_MS);
  return fetch(path, { cache: "no-store", credentials: "same-origin", redirect: "error", ...options, signal: stop.signal });
}

async function change(path, body) {
  const headers = { "Content-Type": "application/json" };
  if (session.token) headers["X-Horopter-Token"] = session.token;
  let answer;
  try {
    answer = await ask(path, { method: "POST", headers, body: JSON.stringify(body), within: 10000 });
  } catch {
    return "The monitor did not answer. Look whether it was done.";
  }
  if (answer.ok) return null;
  try {
    return (await answer.json()).error || `Refused (${answer.status}).`;
  } catch {
    return `Refused (${answer.status}).`;
  }
}

// --- state

function show(state, reason) {
  const [word, usual] = STATES[state] || STATES.none;
  if (document.body.dataset.state !== state) document.body.dataset.state = state;
  if (at("state").textContent !== word) at("state").textContent = word;
  const text = reason || usual;
  if (at("reason").textContent !== text) at("reason").textContent = text;
  // A title stays where the page is hidden or hangs, and nothing covers it: it never says that it is safe.
  document.title = (state === "safe" ? "" : `${word} – `) + (session.title || "Horopter");
  if (state !== "safe") document.body.dataset.safe = "no"; else document.body.dataset.safe = "yes";
}

// Older than it may be, however it came: this runs between answers, too.
function age() {
  if (!last || lastAsked === null || last.age_ms === null) return Infinity;
  return performance.now() - lastAsked + last.age_ms;
}

function showState() {
  if (!session.may_look) return show("none", "Log in to see the state.");
  const silent = !last || lastAsked === null || performance.now() - lastAsked > ANSWER_WITHIN_MS + STATUS_EVERY_MS;
  const old = silent || !(performance.now() - pictureTaken <= 2 * OLD_AFTER_MS);
  document.body.dataset.picture = old ? "old" : "live";
  if (silent) return show("none");
  const limit = Math.max(OLD_AFTER_MS, last.limit_ms);
  if (last.state === "safe" && !(age() <= limit)) return show("old");
  if (last.state === "alarm") {
    const count = last.objects.length;
    return show("alarm", count > 1 ? `${count} objects are in the skin.` : undefined);
  }
  if (last.state === "not_safe") {
    const cause = last.causes[0];
    if (cause) return show("not_safe", cause.text);
    if (last.restart === "possible") return show("not_safe", "All is in order again. It waits for a restart.");
  }
  show(STATES[last.state] ? last.state : "none");
}

function number(value, digits, unit) {
  return value === null || value === undefined ? "–" : `${value.toFixed(digits)} ${unit}`;
}

function showCauses() {
  const list = at("cause-list");
  const now = last.causes;
  const over = last.latched.filter((cause) => !now.some((other) => other.name === cause.name));
  const items = [];
  for (const [causes, isOver] of [[now, false], [over, true]]) {
    for (const cause of causes) {
      const item = element("li", null, isOver ? "over" : "");
      item.append(element("div", (isOver ? "Over: " : "") + (cause.text || cause.name), "text"));
      if (cause.advice) item.append(element("div", cause.advice, "advice"));
      item.append(element("div", cause.name, "name"));
      items.push(item);
    }
  }
  if (last.log && last.log.trouble) {
    const item = element("li");
    item.append(element("div", last.log.trouble.text, "text"), element("div", last.log.trouble.advice, "advice"));
    items.push(item);
  }
  if (last.users_trouble) items.push(element("li", "The file of users cannot be read: nobody can log in."));
  const text = JSON.stringify([now, over, last.log && last.log.trouble, last.users_trouble]);
  if (list.dataset.shown !== text) {
    list.dataset.shown = text;
    list.replaceChildren(...items);
  }
  at("causes").hidden = items.length === 0;
}

function showActions() {
  const stopped = last.state !== "safe";
  const wants = last.restart !== "not_needed" && !last.restart_by_itself;
  at("restart").hidden = !(session.may_restart && stopped && wants);
  at("restart").disabled = last.restart !== "possible";
  at("teach").hidden = !session.may_teach;
  at("teach").disabled = last.teaching || !session.teach_allowed;
  at("teach").textContent = last.teaching ? "It is being taught…" : "Teach the empty zone…";
  let hint = "";
  if (stopped && wants && last.restart === "needed") hint = "A restart is possible once the last pictures were good.";
  if (stopped && wants && last.restart === "possible") {
    if (!session.restart_allowed || !session.login_possible) {
      hint = "Nobody can restart this cell: cell.yaml needs `web: {users_file: …, restart: true}`.";
    } else if (!session.user) hint = "Log in as operator to restart.";
    else if (!session.may_restart) hint = `The role ${session.role} may not restart. Ask an operator.`;
  }
  if (session.may_teach && !session.teach_allowed) {
    hint += " Nobody can teach this cell: its cell.yaml does not say `teach: {needed: true}`.";
  }
  at("hint").textContent = hint.trim();
  at("do").hidden = at("restart").hidden && at("teach").hidden && !hint;
}

function showObjects() {
  const rows = last.objects.map((object) => row([
    object.id, number(object.size_mm, 0, "mm"), number(object.distance_mm, 0, "mm"),
    object.speed_mm_s === null ? "–" : number(object.speed_mm_s / 1000, 2, "m/s"), object.pixels]));
  at("objects").tBodies[0].replaceChildren(...rows);
  at("objects").hidden = rows.length === 0;
  at("no-objects").hidden = rows.length !== 0;
  at("no-objects").textContent = last.state === "old" ? "Nobody knows: no new picture was judged." : "Nothing in the skin.";
}

function showCameras() {
  const [left, right] = last.cameras;
  const lines = [
    ["connected", (c) => (c.connected ? "yes" : "NO"), (c) => !c.connected],
    ["pictures per second", (c) => c.frames_per_s.toFixed(1)],
    ["sharpness", (c) => c.sharpness.toFixed(2)],
    ["exposure", (c) => (c.exposure_us === null ? "–" : number(c.exposure_us / 1000, 2, "ms"))],
    ["dropped", (c) => c.dropped, (c) => c.dropped > 0],
    ["lost packets", (c) => c.lost_packets, (c) => c.lost_packets > 0],
    ["repeated", (c) => c.repeated, (c) => c.repeated > 0],
  ];
  at("cameras").tBodies[0].replaceChildren(...lines.map(([name, value, bad]) =>
    row([name, ...[left, right].map((camera) => {
      const cell = element("td", camera ? value(camera) : "–");
      if (camera && bad && bad(camera)) cell.className = "bad";
      return cell;
    })])));
  const facts = [
    ["explained share", last.explained === null ? "–" : `${(100 * last.explained).toFixed(0)} %`],
    ["skew between the two", number(last.skew_ms, 2, "ms")],
    ["decision after", number(last.decision_ms, 1, "ms")],
    ["taught", last.teaching ? "now" : last.taught ? "yes" : "no"],
    ["table", last.table === 15 ? "none" : `${last.table}, CRC ${last.table_crc}`],
  ];
  at("facts").tBodies[0].replaceChildren(...facts.map((line) => row(line)));
}

async function readStatus() {
  const asked = performance.now();
  const answer = await ask("/api/status");
  if (answer.status === 401) {
    session.may_look = false;
    await readNewSession();
    return;
  }
  if (!answer.ok) throw new Error("status");
  const json = await answer.json();
  last = json;
  lastAsked = asked;
  beat = !beat;
  document.body.dataset.beat = beat ? "a" : "b";
  showState();
  showCauses();
  showActions();
  showObjects();
  showCameras();
  at("clock").textContent = new Date().toLocaleTimeString();
  const trouble = last.log && last.log.trouble;
  at("log-trouble").hidden = !trouble;
  at("log-trouble").textContent = trouble ? `${trouble.text} ${trouble.advice}` : "";
  if (last.log && last.log.newest !== newestEvent) await readLog();
}

async function readPicture() {
  if (!session.may_look || document.hidden) return;
  const asked = performance.now();
  const answer = await ask("/api/picture");
  if (!answer.ok) {
    pictureTaken = -Infinity;
    return;
  }
  const ageMs = Number(answer.headers.get("X-Horopter-Age-Ms"));
  const frame = answer.headers.get("X-Horopter-Frame");
  const url = URL.createObjectURL(await answer.blob());
  const picture = at("picture");
  const before = picture.src;
  picture.src = url;
  picture.hidden = false;
  at("no-picture").hidden = true;
  if (before.startsWith("blob:")) URL.revokeObjectURL(before);
  pictureTaken = asked - ageMs;
  at("picture-facts").textContent = `pair ${frame}`;
}

// --- session

async function readNewSession() {
  sessionIsOld = true;
  try {
    await readSession();
  } catch {
    // Asked for again, round and round.
  }
}

async function readSession() {
  const answer = await ask("/api/session");
  if (!answer.ok) throw new Error("session");
  session = await answer.json();
  sessionIsOld = false;
  at("title").textContent = session.title;
  at("who").textContent = session.user ? `${session.user}, ${session.role}` : session.may_look ? "viewer" : "";
  at("login-open").hidden = !session.login_possible || session.user !== null;
  at("logout").hidden = session.user === null;
  if (session.user === null) at("confirm").close();  // who asked is gone, and with the session perhaps the monitor
  if (!session.may_look) {
    last = null;
    lastAsked = null;
    newestEvent = null;
    at("picture").removeAttribute("src");
    at("picture").hidden = true;
    at("no-picture").hidden = false;
    at("causes").hidden = true;
    at("do").hidden = true;
    at("events").tBodies[0].replaceChildren();
    if (!at("login").open) openLogin();
  }
  showState();
}

function openLogin() {
  at("login-trouble").hidden = true;
  at("login-password").value = "";
  at("login").showModal();
}

async function logIn(event) {
  event.preventDefault();
  at("login-send").disabled = true;
  const trouble = await change("/api/login", { name: at("login-name").value, password: at("login-password").value });
  at("login-send").disabled = false;
  at("login-password").value = "";
  at("login-trouble").hidden = !trouble;
  at("login-trouble").textContent = trouble || "";
  if (trouble) return;
  at("login").close();
  at("unanswered").hidden = true;
  await readNewSession();
}

async function logOut() {
  const trouble = await change("/api/logout", {});
  at("unanswered").hidden = !trouble;
  await readNewSession();
}

// --- what may be asked for

function confirm(title, text, check, word, send) {
  at("confirm-title").textContent = title;
  at("confirm-text").textContent = text;
  at("confirm-check").textContent = check;
  at("confirm-send").textContent = word;
  at("confirm-send").disabled = true;
  at("confirm-looked").checked = false;
  at("confirm-trouble").hidden = true;
  at("confirm").querySelector("form").onsubmit = async (event) => {
    event.preventDefault();
    at("confirm-send").disabled = true;
    const trouble = await send();
    at("confirm-trouble").hidden = !trouble;
    at("confirm-trouble").textContent = trouble || "";
    if (!trouble) at("confirm").close();
  };
  at("confirm").showModal();
}

function openRestart() {
  const stop = last.stop;  // as it is seen now
  confirm("Restart", "The machine may move again as soon as you restart. What has crossed the skin is no longer seen.",
    "I have looked: nobody is inside.", "Restart", () => change("/api/restart", { stop }));
}

function openTeach() {
  const frames = session.teach_frames;
  const stop = last.stop;  // as it is seen now
  confirm("Teach the empty zone", `For the next ${frames} pairs the monitor learns what cannot be decided while the zone is empty.`,
    "The zone is empty, and stays so.", "Teach", () => change("/api/teach", { frames, stop }));
}

// --- log

function when(text) {
  const time = new Date(text);
  return isNaN(time) ? text : time.toLocaleString([], { year: "numeric", month: "2-digit", day: "2-digit", hour: "2-digit", minute: "2-digit", second: "2-digit" });
}

function eventRow(event) {
  const cell = element("td");
  if (event.kind === "stop") {
    const button = element("button", event.pictures ? "Pictures" : "Details", "plain");
    button.onclick = () => openEvent(event.number);
    cell.append(button);
  }
  const by = event.by ? ` (${event.by})` : "";
  const word = event.kind === "stop" ? "Stop: " : "";
  return row([event.number, when(event.time), word + event.text + by, cell], event.kind);
}

async function readLog() {
  const answer = await ask("/api/log");
  if (!answer.ok) return;
  const { events } = await answer.json();
  newestEvent = events.length ? events[0].number : 0;
  shownEvents = events;
  at("events").tBodies[0].replaceChildren(...events.map(eventRow));
  at("older").hidden = events.length < 50;
}

// What a click asks of the log. Null, and that is said, where there is no answer.
async function askLog(path) {
  let json = null;
  try {
    const answer = await ask(path);
    if (answer.ok) json = await answer.json();
  } catch {
    // Too late, or none.
  }
  at("unanswered").hidden = json !== null;
  return json;
}

async function readOlder() {
  const older = await askLog(`/api/log?before=${shownEvents[shownEvents.length - 1].number}`);
  if (!older) return;
  const { events } = older;
  shownEvents = shownEvents.concat(events);
  at("events").tBodies[0].append(...events.map(eventRow));
  at("older").hidden = events.length < 50;
}

async function openEvent(eventNumber) {
  const found = await askLog(`/api/log/${eventNumber}`);
  if (!found) return;
  const { event, pictures, complete } = found;
  at("event-title").textContent = `Event ${event.number}, ${when(event.time)}`;
  at("event-text").textContent = complete ? "" : "Its pictures are still being written.";
  at("event-causes").replaceChildren(...event.causes.map((cause) => {
    const item = element("li");
    item.append(element("strong", cause.text || cause.name));
    if (cause.advice) item.append(element("div", cause.advice, "advice"));
    item.append(element("div", cause.name, "name"));
    return item;
  }));
  const facts = [["pair", event.frame], ["table", `${event.table}, CRC ${event.table_crc}`], ["configuration", event.configuration]];
  for (const [name, version] of Object.entries(event.versions || {})) facts.push([name, version]);
  for (const object of event.objects) {
    facts.push([`object ${object.id}`, [`${object.pixels} px`, object.size_mm === null ? null : `${object.size_mm.toFixed(0)} mm`,
      object.distance_mm === null ? null : `at ${object.distance_mm.toFixed(0)} mm`,
      object.speed_mm_s === null ? null : `${(object.speed_mm_s / 1000).toFixed(2)} m/s`].filter(Boolean).join(", ")]);
  }
  at("event-facts").tBodies[0].replaceChildren(...facts.map((line) => row(line)));

  const frames = [...new Set(pictures.map((name) => name.match(/^frame-\d+/)?.[0]).filter(Boolean))].sort();
  const place = at("event-place");
  at("event-pictures").hidden = frames.length === 0;
  place.max = Math.max(0, frames.length - 1);
  const stopped = `frame-${String(event.frame).padStart(8, "0")}`;
  place.value = Math.max(0, frames.indexOf(stopped));
  const showPicture = () => {
    const frame = frames[Number(place.value)];
    const kind = document.querySelector("input[name=kind]:checked").value;
    const name = pictures.find((other) => other.startsWith(`${frame}-${kind}`));
    at("event-name").textContent = frame === stopped ? `${frame}: the pair that stopped it` : frame;
    if (name) at("event-picture").src = `/api/log/${event.number}/${name}`;
  };
  place.oninput = showPicture;
  for (const radio of document.querySelectorAll("input[name=kind]")) radio.onchange = showPicture;
  at("event-back").onclick = () => { place.value = Number(place.value) - 1; showPicture(); };
  at("event-next").onclick = () => { place.value = Number(place.value) + 1; showPicture(); };
  if (frames.length) showPicture();
  if (!at("event").open) at("event").showModal();
}

const eventKey = at("key").cloneNode(true);
eventKey.removeAttribute("id");
eventKey.className = "key-list";
at("event-key").append(eventKey);

// --- round and round

function forever(work, every) {
  const turn = async () => {
    try {
      await work();
    } catch {
      showState();  // what is old says so
    }
    setTimeout(turn, every);
  };
  turn();
}

at("login-open").onclick = openLogin;
at("login").querySelector("form").addEventListener("submit", logIn);
at("logout").onclick = logOut;
at("restart").onclick = openRestart;
at("teach").onclick = openTeach;
at("confirm-looked").onchange = () => { at("confirm-send").disabled = !at("confirm-looked").checked; };
at("older").onclick = readOlder;
for (const button of document.querySelectorAll("dialog .close")) button.onclick = () => button.closest("dialog").close();
// A page that was hidden, or a computer that slept, has nothing to show until it has heard again.
document.addEventListener("visibilitychange", () => { lastAsked = null; showState(); });
setInterval(showState, 100);
forever(async () => { if (sessionIsOld) await readSession(); else if (session.may_look) await readStatus(); }, STATUS_EVERY_MS);
forever(readPicture, PICTURE_EVERY_MS);
