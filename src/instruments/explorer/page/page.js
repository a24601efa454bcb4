// What the page is about: its data, and where it tells what went wrong.

const element = id => document.getElementById(id);

/// Tells the user that something went wrong.
function tell(text) {
  element("error").textContent = text;
  element("error").hidden = false;
}

addEventListener("error", event => tell(event.message));
addEventListener("unhandledrejection", event => tell(String(event.reason?.message ?? event.reason)));

const page = JSON.parse(element("data").textContent);  // as src/instruments/explorer/explorer_page.cpp writes it
const bodies = page.bodies.map(readBody);  // of sound maps; those that the page makes are added
