// node site.mjs FOLDER [PICTURES]: opens the website of a folder in Chromium without a window, on a desktop and on a phone. Uses the
// menu, the search and the players, and writes screenshots if a folder for them is given. Prints what it saw as JSON.
import {createServer} from "node:http";
import {readFile} from "node:fs/promises";
import {extname, join, normalize} from "node:path";
import {open} from "./browser.mjs";

const [folder, pictures] = process.argv.slice(2);
const types = {".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".json": "application/json", ".png": "image/png", ".wav": "audio/wav"};
const server = createServer(async (request, response) => {
  const path = normalize(decodeURIComponent(new URL(request.url, "http://host").pathname));
  try {
    const bytes = await readFile(join(folder, path));
    response.writeHead(200, {"Content-Type": types[extname(path)] ?? "application/octet-stream"}).end(bytes);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise(ready => server.listen(0, "127.0.0.1", ready));
const address = `http://127.0.0.1:${server.address().port}`;

async function look(width, height, name) {
  const {browser, page, complaints} = await open(`${address}/index.html`, width, height);
  const elsewhere = [];
  page.on("request", request => request.url().startsWith(address) || elsewhere.push(request.url()));
  const wide = [];
  for (const path of ["index.html", "sounds.html", "docs/use/deck.html", "docs/method/verification.html", "verification/report.html"]) {
    await page.goto(`${address}/${path}`);
    await page.waitForLoadState("networkidle");
    if (await page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth)) wide.push(path);
    if (pictures) await page.screenshot({path: join(pictures, `${name}_${path.replaceAll("/", "_")}.png`)});
  }
  await page.goto(`${address}/sounds.html`);
  const players = await page.evaluate(() => Promise.all([...document.querySelectorAll("audio")].map(player => new Promise(done => {
    player.addEventListener("loadedmetadata", () => done(player.duration));
    player.addEventListener("error", () => done(0));
    player.preload = "metadata";
    player.load();
  }))));
  const broken = await page.evaluate(() => [...document.images].filter(image => !image.complete || image.naturalWidth === 0).length);
  if (width < 600) await page.locator("label[for=__search]").first().click();
  await page.locator("input[name=query]").fill("retarded time");
  await page.locator(".md-search-result__item a").first().waitFor();
  const found = await page.locator(".md-search-result__item h1").allTextContents();
  await browser.close();
  return {complaints, elsewhere, wide, players, broken, found};
}

const seen = {desktop: await look(1280, 800, "desktop"), phone: await look(390, 760, "phone")};
server.close();
console.log(JSON.stringify(seen));
